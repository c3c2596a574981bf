// Processor time, which other programs on the machine hardly change.
#pragma once

#include <ctime>

namespace axiscert {

// Of the calling thread, in seconds, since it began.
inline double thread_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace axiscert
