// Processor time, which other programs on the machine hardly influence.
#pragma once

#include <ctime>

namespace axiscert {

// Processor time of the calling thread since it began, in seconds.
inline double thread_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace axiscert
