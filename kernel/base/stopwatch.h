// Wall time in nanoseconds, for the counters of a run. No result depends on it.
#pragma once

#include <chrono>
#include <utility>

namespace axiscert {

class Stopwatch {
 public:
  // The time since the last lap, or since the construction, in nanoseconds.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double, std::nano>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace axiscert
