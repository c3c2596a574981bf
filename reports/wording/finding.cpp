#include "reports/wording/finding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::string times(std::uint64_t count) { return count == 1 ? "once" : thousands(count) + " times"; }

bool are_alike(const FindingRecord& x, const FindingRecord& y) {
  return x.kernel == y.kernel && x.precision == y.precision && x.kind == y.kind;
}

}  // namespace

std::string finding_text(const FindingRecord& finding) {
  const std::string in = finding.precision ? fmt::format(" {}", name(*finding.precision)) : "";
  const std::string who = fmt::format("{}{}: {}", finding.kernel, in, name(finding.kind));
  if (!finding.family) return fmt::format("{}: {}", who, finding.detail);
  return fmt::format("{} on family {}, {}, first at {}: {}", who, *finding.family, times(finding.count),
                     finding.address.value_or(""), finding.detail);
}

std::string FindingGroup::others_text() const {
  std::vector<std::string> families;
  for (const FindingRecord* other : others) {
    families.push_back(fmt::format("{} ({})", other->family.value_or(""), times(other->count)));
  }
  return families.empty() ? "" : fmt::format("also on family {}", fmt::join(families, ", "));
}

std::vector<FindingGroup> finding_groups(const Record& record) {
  std::vector<FindingGroup> groups;
  for (const FindingRecord& finding : record.findings) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const FindingGroup& group) {
      return finding.family && are_alike(*group.first, finding);
    });
    if (same == groups.end()) groups.push_back({&finding, {}});
    else same->others.push_back(&finding);
  }
  return groups;
}

bool is_about(const FindingRecord& finding, const KernelRecord& kernel) {
  return finding.kernel == kernel.id && (!finding.precision || *finding.precision == kernel.precision);
}

std::vector<std::string> not_judged(const Record& record) {
  std::vector<std::string> ids;
  for (const Name& id : record.plan.kernels) {
    const auto& entries = record.kernels;
    const bool judged = std::any_of(entries.begin(), entries.end(), [&](const KernelRecord& e) { return e.id == id; });
    if (!judged) ids.push_back(id);
  }
  return ids;
}

}  // namespace axiscert
