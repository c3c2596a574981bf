// decided=SHARE: a kernel that may decline decides at least so many of the exact contacts and of the exact separations
// of each family. Beside other levels it names the share that these ask for.
#include <fmt/format.h>

#include "reports/gates/level.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

double decided_argument(const AskedLevel& asked) {
  return number_argument(asked, {"SHARE",
                                 "the part of the contacts, and of the separations, of each family that has to be "
                                 "decided: above 0 and at most 1",
                                 "0.9", above_0, 1});
}

LevelFindings judge_decided(const AskedLevel& asked, const Subject& subject) {
  const double share = decided_argument(asked);
  LevelFindings found;
  for (const auto& [family, result] : subject.families()) {
    const Evidence evidence = subject.evidence(result);
    found.families[family] = {evidence.population, evidence.promised()};  // a declined query is an answer to this level
    const auto check = [&](std::uint64_t declined, std::uint64_t of, const char* what) {
      if (!declines_too_many(declined, of, share)) return;
      subject.add(
          found.failures, family, declined,
          fmt::format("{} declined, of {} promised, and {} of these have to be decided", what, thousands(of), share),
          [](const FlipRecord&) { return false; });
    };
    check(evidence.declined_contacts, evidence.contacts, "contacts");
    check(evidence.declined_separations, evidence.separations, "separations");
  }
  found.covers = fmt::format("the promised queries of {}, which it answers by a verdict, right or wrong, or declines",
                             subject.list_of_families());
  found.leaves_out = "whether the verdicts are right";
  return found;
}

}  // namespace

extern const GateLevel decided_level = {
    .usage = "decided=SHARE",
    .meaning =
        "at least SHARE of the contacts and of the separations of each family decided, and other levels ask "
        "for that share in place of 0.5",
    .sentence =
        [](const AskedLevel& asked) {
          return fmt::format("at least {} of the exact contacts, and of the exact separations, of each family decided",
                             decided_argument(asked));
        },
    .judge = judge_decided,
    .decided_share = decided_argument,
    .in_certificates = {}};

}  // namespace axiscert
