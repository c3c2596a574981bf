// The section of report.md on how deep wrong verdicts are.
#pragma once

#include <string>

#include "fuzz/record/record.h"

namespace axiscert {

// Empty where nothing is wrong, and for a predicate without depths.
std::string depths_section(const Record& record);

}  // namespace axiscert
