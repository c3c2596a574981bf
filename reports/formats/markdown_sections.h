// The section of report.md on why kernels are wrong whose links do not say it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fuzz/record/record.h"
#include "reports/gates/requirement.h"

namespace axiscert {
// Empty where no kernel of the record has a wrong verdict in a class of input.
std::string classes_section(const Record& record);

// The section of report.md on how deep wrong verdicts are.

// Empty where nothing is wrong, and for a predicate without depths.
std::string depths_section(const Record& record);

// The section of report.md on the first contacts that kernels report.

// Empty for a predicate without measures, and where there is nothing to say.
std::string motion_section(const Record& record);

// The section of report.md on what was required and what came of it.

// Empty where nothing is required.
std::string requirements_section(const Record& record, const std::vector<LevelOutcome>& outcomes);

// The sections of report.md on axes and on comparisons.

// The axes or the comparisons of each kernel over all families, those with a flip first. `totals`: all_families() of
// the record's kernels, in their order.
std::string axes_section(const Record& record, const std::vector<std::optional<FamilyRecord>>& totals);
std::string comparisons_section(const Record& record, const std::vector<std::optional<FamilyRecord>>& totals);

}  // namespace axiscert
