// The sections of report.md on axes and on comparisons.
#pragma once

#include <string>
#include <vector>

#include "fuzz/text/json.h"

namespace axiscert {

// The axes or the comparisons of each kernel over all families, those with a flip first. `totals`: all_families() of
// the record's kernels, in their order; `level`: "axes" or "comparisons".
std::string signs_section(const Json& record, const std::vector<Json>& totals, const std::string& level);

}  // namespace axiscert
