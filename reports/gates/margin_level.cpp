// keeps-margin: a kernel that declares a margin reports contact within it. The declaration allows either answer there,
// so no other level asks.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "fuzz/queries/source.h"
#include "reports/gates/level.h"
#include "reports/wording/depths.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

LevelFindings judge_keeps_margin(const AskedLevel&, const Subject& subject) {
  LevelFindings found;
  std::vector<std::string> families;
  std::uint64_t within = 0, generated = 0;  // a file has the queries that it has
  for (const auto& [family, result] : subject.families()) {
    const std::optional<WithinMargin> look = within_margin(subject.kernel(), result);
    if (!look || look->answered == 0) {
      found.unseen.push_back(family);
      continue;
    }
    within += look->answered;
    if (!is_query_list(family)) generated += look->answered;
    families.push_back(family);
    found.families[family] = {look->answered, look->answered};
    subject.add(found.failures, family, look->answered - look->contacts,
                "apart by no more than its margin, and not called contact", [](const FlipRecord&) { return false; });
  }
  if (within == 0) {
    found.not_checked = why_no_margin(subject.kernel());
    return found;
  }
  if (generated != 0 && generated < least_looked_at) {
    found.not_checked = fmt::format("{} generated {} apart by no more than its margin, and {} are needed",
                                    thousands(generated), generated == 1 ? "query is" : "queries are", least_looked_at);
  }
  found.covers =
      fmt::format("{} queries of {}, apart by no more than the margin", thousands(within), fmt::join(families, ", "));
  if (!found.unseen.empty())
    leave_out(found.leaves_out, fmt::format("no query within the margin: {}", fmt::join(found.unseen, ", ")));
  leave_out(found.leaves_out, "whether contact is right beyond the margin, which the other levels ask");
  return found;
}

}  // namespace

extern const GateLevel keeps_margin_level = {
    .usage = "keeps-margin",
    .meaning = "contact wherever the two are apart by no more than the margin that the kernel declares",
    .sentence =
        [](const AskedLevel&) {
          return std::string("contact wherever the two are apart by no more than the margin that the kernel declares");
        },
    .judge = judge_keeps_margin,
    .looks_at = "queries apart by no more than its margin",
    .in_certificates = {}};  // few kernels declare one

}  // namespace axiscert
