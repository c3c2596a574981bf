// What built this program and what it runs on: for run.json and for benchmarks, never for a record.
#pragma once

#include <string>

namespace axiscert {

std::string compiler_name();   // "g++ 12.2.0"
std::string compiler_flags();  // those of the build type
std::string processor_name();  // as Linux has it, or "unknown"

}  // namespace axiscert
