#include "reports/wording/margin.h"

#include <fmt/format.h>

#include "reports/wording/summary.h"

namespace axiscert {
namespace {

bool has_margin_alone(const KernelRecord& kernel) {
  const LimitsRecord limits = kernel.limits.value_or(LimitsRecord());
  const bool has_others = limits.least_coordinate || limits.greatest_coordinate || limits.least_area ||
                          limits.least_radius || limits.greatest_radius ||
                          limits.sides.value_or(SidesPolicy::both) != SidesPolicy::both ||
                          kernel.motion.value_or(PolicyRecord()) != PolicyRecord();
  return limits.margin && !has_others;
}

}  // namespace

std::optional<WithinMargin> within_margin(const KernelRecord& kernel, const FamilyRecord& result) {
  const std::optional<OutsideTally>& outside = result.verdict.outside_limits;
  if (!has_margin_alone(kernel) || !outside) return std::nullopt;
  return WithinMargin{outside->trials - outside->unanswered, outside->false_contact};
}

std::string why_no_margin(const KernelRecord& kernel) {
  if (!kernel.limits || !kernel.limits->margin) return "the kernel declares no margin";
  if (!has_margin_alone(kernel))
    return "the kernel declares other limits too, and the record counts all queries outside them together";
  return fmt::format("no query is apart by no more than its margin of {}", *kernel.limits->margin);
}

std::string broken_margin_text(const KernelRecord& kernel) {
  WithinMargin all;
  for (const auto& [family, result] : kernel.families) {
    const WithinMargin look = within_margin(kernel, result).value_or(WithinMargin());
    all.answered += look.answered;
    all.contacts += look.contacts;
  }
  if (all.contacts == all.answered) return "";
  return fmt::format("declares a margin of {}, and does not call {} of {} queries that are apart by no more contact",
                     *kernel.limits->margin, thousands(all.answered - all.contacts), thousands(all.answered));
}

}  // namespace axiscert
