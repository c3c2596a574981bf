// The section of report.md on the first contacts that kernels report.
#pragma once

#include <string>

#include "fuzz/record/record.h"

namespace axiscert {

// Empty for a predicate without measures, and where there is nothing to say.
std::string motion_section(const Record& record);

}  // namespace axiscert
