// The section of report.md on how deep wrong verdicts are.
#pragma once

#include <string>

#include "fuzz/text/json.h"

namespace axiscert {

// Empty where nothing is wrong, and where the record has no depths by decade.
std::string depths_section(const Json& record);

}  // namespace axiscert
