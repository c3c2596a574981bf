#include "reports/wording/finding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::string times(const Json& count) { return count == 1 ? "once" : thousands(count.get<std::uint64_t>()) + " times"; }

}  // namespace

std::string finding_text(const Json& finding) {
  const auto text = [&](const char* member) { return finding[member].get<std::string>(); };
  if (finding["family"].is_null()) {
    const std::string in = finding["precision"].is_null() ? "" : " " + text("precision");
    return fmt::format("{}{}: {}: {}", text("kernel"), in, text("kind"), text("detail"));
  }
  return fmt::format("{} {}: {} on family {}, {}, first at {}: {}", text("kernel"), text("precision"), text("kind"),
                     text("family"), times(finding["count"]), text("address"), text("detail"));
}

std::string FindingGroup::others_text() const {
  std::vector<std::string> families;
  for (const Json* other : others) {
    families.push_back(fmt::format("{} ({})", (*other)["family"].get<std::string>(), times((*other)["count"])));
  }
  return families.empty() ? "" : fmt::format("also on family {}", fmt::join(families, ", "));
}

std::vector<FindingGroup> finding_groups(const Json& record) {
  std::vector<FindingGroup> groups;
  for (const Json& finding : record["findings"]) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const FindingGroup& group) {
      const auto equal = [&](const char* member) { return (*group.first)[member] == finding[member]; };
      return equal("kernel") && equal("precision") && equal("kind") && !finding["family"].is_null();
    });
    if (same == groups.end()) groups.push_back({&finding, {}});
    else same->others.push_back(&finding);
  }
  return groups;
}

bool is_about(const Json& finding, const Json& kernel) {
  return finding["kernel"] == kernel["id"] &&
         (finding["precision"].is_null() || finding["precision"] == kernel["precision"]);
}

std::vector<std::string> not_judged(const Json& record) {
  std::vector<std::string> ids;
  for (const Json& id : record["plan"]["kernels"]) {
    const auto& entries = record["kernels"];
    const bool judged = std::any_of(entries.begin(), entries.end(), [&](const Json& e) { return e["id"] == id; });
    if (!judged) ids.push_back(id);
  }
  return ids;
}

}  // namespace axiscert
