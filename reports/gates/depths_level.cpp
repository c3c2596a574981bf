// The levels of wrong verdicts whatever their cause: exact, conservative and depth.
#include <fmt/format.h>

#include "exact/judge/oracles.h"
#include "fuzz/text/number_text.h"
#include "reports/gates/level.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

LevelFindings judge_depths(const Subject& subject, const AllowedDepths& allowed) {
  LevelFindings found;
  const double metres_of_unit = metres_of(subject.record().plan);
  for (const auto& [family, result] : subject.families()) {
    const VerdictTally& verdict = result.verdict;
    const auto check = [&, family = family](FlipKind kind, std::uint64_t count, double deepest, double farthest,
                                            const std::string& what, double most) {
      const double metres = farthest * metres_of_unit;
      if ((allowed.are_lengths && most != no_wrong ? metres : deepest) <= most) return;
      std::string how_deep;
      if (most != no_wrong) {
        how_deep = fmt::format(", the worst by {}: {} is allowed",
                               allowed.are_lengths ? metric_text(metres) : fmt::format("{:.4g} of the scene", deepest),
                               SizeLimit{most, allowed.are_lengths}.text());
      }
      if (allowed.are_lengths) {
        subject.add_shown(found.failures, family, count, what + how_deep, fmt::format("farthest {}", name(kind)));
      } else {
        subject.add(found.failures, family, count, what + how_deep,
                    [kind](const FlipRecord& flip) { return flip.kind == kind; });
      }
    };
    check(FlipKind::false_separation, verdict.false_separation, verdict.deepest_false_separation.best(),
          verdict.farthest_false_separation.best(), "missed contacts", allowed.missed);
    check(FlipKind::false_contact, verdict.false_contact, verdict.deepest_false_contact.best(),
          verdict.farthest_false_contact.best(), "phantom contacts", allowed.phantom);
    found.families[family] = subject.whole_look(result);
  }
  found.covers =
      fmt::format("{} queries of {}, each judged exactly", thousands(subject.decided()), subject.list_of_families());
  found.leaves_out = "queries that these families do not make";
  return found;
}

LevelFindings judge_to_depth(const Subject& subject, const AllowedDepths& allowed) {
  LevelFindings found = judge_depths(subject, allowed);
  const Predicate& predicate = predicate_of(subject.record().plan);
  if (!oracles_of(predicate).has_depth())
    found.not_checked = fmt::format("the predicate {} states no depth of a wrong verdict", predicate.id);
  return found;
}

AllowedDepths conservative_depths(const AskedLevel& asked) {
  if (!asked.has_argument) return {no_wrong, any_depth};
  const SizeLimit limit = depth_argument(asked);
  return {no_wrong, limit.most, limit.is_length};
}

// No contact is missed where there is none. The plain level looks at contacts alone, since no answer to another query
// could break it.
LevelFindings judge_conservative(const AskedLevel& asked, const Subject& subject) {
  const AllowedDepths allowed = conservative_depths(asked);
  LevelFindings found = asked.has_argument ? judge_to_depth(subject, allowed) : judge_depths(subject, allowed);
  std::uint64_t contacts = 0, decided = 0;
  for (const auto& [family, result] : subject.families()) {
    const Evidence evidence = subject.evidence(result);
    const std::uint64_t here = evidence.decided_for(FlipKind::false_separation);
    decided += here;
    contacts += contacts_of(subject.kernel().touching, result.truth);
    if (asked.has_argument) continue;
    found.families[family] = {evidence.contacts, here};
    if (here == 0 && evidence.promised() != 0) found.unseen.push_back(family);
  }
  if (contacts == 0 && found.not_checked.empty()) found.not_checked = "no query is a contact that it could miss";
  if (!asked.has_argument) {
    found.covers =
        fmt::format("{} contacts of {}, each judged exactly", thousands(decided), subject.list_of_families());
  }
  return found;
}

AllowedDepths either_way(const AskedLevel& asked) {
  const SizeLimit limit = depth_argument(asked);
  return {limit.most, limit.most, limit.is_length};
}

std::string conservative_sentence(const AskedLevel& asked) {
  return "no missed contact" +
         (asked.has_argument ? fmt::format(", and no phantom contact deeper than {}", depth_argument(asked).text())
                             : "");
}

}  // namespace

extern const GateLevel exact_level = {.usage = "exact",
                                      .meaning = "no wrong verdict",
                                      .sentence = [](const AskedLevel&) { return std::string("no wrong verdict"); },
                                      .judge =
                                          [](const AskedLevel&, const Subject& subject) {
                                            LevelFindings found = judge_depths(subject, {no_wrong, no_wrong});
                                            subject.add_untimed(found.failures);
                                            return found;
                                          },
                                      .allowed =
                                          [](const AskedLevel&) {
                                            return AllowedDepths{no_wrong, no_wrong};
                                          },
                                      .breaking = "are wrong",
                                      .badge = Badge{1, "#2e7d32"}};

extern const GateLevel conservative_level = {
    .usage = "conservative[=D]",
    .meaning = "no missed contact, no phantom contact deeper than D",
    .sentence = conservative_sentence,
    .judge = judge_conservative,
    .allowed = conservative_depths,
    .part = [](const AskedLevel& asked) -> const char* { return asked.has_argument ? nullptr : "contacts"; },
    .in_certificates = no_or_visible_depth,
    .badge = Badge{2, "#2e7d32"}};

extern const GateLevel depth_level = {
    .usage = "depth=D",
    .meaning = "no wrong verdict deeper than D, a share of the scene or a length such as 1mm, either way",
    .sentence =
        [](const AskedLevel& asked) {
          return fmt::format("no wrong verdict deeper than {}, either way", depth_argument(asked).text());
        },
    .judge = [](const AskedLevel& asked, const Subject& subject) { return judge_to_depth(subject, either_way(asked)); },
    .allowed = either_way,
    .in_certificates = visible_depths};

}  // namespace axiscert
