// The section of report.md on why kernels are wrong whose links do not say it.
#pragma once

#include <string>

#include "fuzz/record/record.h"

namespace axiscert {

// Empty where no kernel of the record has a wrong verdict in a class of input.
std::string classes_section(const Record& record);

}  // namespace axiscert
