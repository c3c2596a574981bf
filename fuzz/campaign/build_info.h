// The compiler that built this program and the processor it runs on: for run.json and for benchmarks, never for a
// record.
#pragma once

#include <string>

namespace axiscert {

std::string compiler_name();   // "g++ 12.2.0"
std::string compiler_flags();  // those of every kernel: "-O2 -ffp-contract=off"
std::string processor_name();  // as Linux reports it, or "unknown"

}  // namespace axiscert
