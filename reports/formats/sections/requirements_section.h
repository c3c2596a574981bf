// The section of report.md on what was required and what came of it.
#pragma once

#include <string>
#include <vector>

#include "reports/gates/requirement.h"

namespace axiscert {

// Empty where nothing is required.
std::string requirements_section(const Record& record, const std::vector<LevelOutcome>& outcomes);

}  // namespace axiscert
