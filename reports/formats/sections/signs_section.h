// The sections of report.md on axes and on comparisons.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fuzz/record/record.h"

namespace axiscert {

// The axes or the comparisons of each kernel over all families, those with a flip first. `totals`: all_families() of
// the record's kernels, in their order.
std::string axes_section(const Record& record, const std::vector<std::optional<FamilyRecord>>& totals);
std::string comparisons_section(const Record& record, const std::vector<std::optional<FamilyRecord>>& totals);

}  // namespace axiscert
