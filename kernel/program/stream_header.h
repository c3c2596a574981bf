// The header that a program reads before the queries of each batch.
#pragma once

#include <string>

#include "kernel/program/pipe_format.h"

namespace axiscert::plugin {

// Its bytes, with a count of 0. The plan names the test, its entry and the precision; nothing can be made again from
// it.
std::string program_header(const TestDescription& test, std::size_t entry, Precision precision);

}  // namespace axiscert::plugin
