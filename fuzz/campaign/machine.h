// The machine, for run.json and for benchmarks, never for a record: the compiler that built this program, the processor
// it runs on, and processor time.
#pragma once

#include <ctime>
#include <string>

namespace axiscert {
std::string compiler_name();   // "g++ 12.2.0"
std::string compiler_flags();  // those of every kernel: "-O2 -ffp-contract=off"
std::string processor_name();  // as Linux reports it, or "unknown"

// Processor time, which other programs on the machine hardly influence.

// Processor time of the calling thread since it began, in seconds.
inline double thread_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace axiscert
