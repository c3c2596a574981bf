// The section of report.md on the first contacts that kernels report.
#pragma once

#include <string>

#include "fuzz/text/json.h"

namespace axiscert {

// Empty for a test without measures, and where there is nothing to say.
std::string motion_section(const Json& record);

}  // namespace axiscert
