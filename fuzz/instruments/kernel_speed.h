// How long a kernel takes for a verdict. The one figure of an instrument that no second run repeats.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert {

// 2^17 distinct queries of family `general`, more than the caches of one core hold; each kernel answers them once in
// every repetition, so that what slows the machine down for a while meets all of them.
inline constexpr std::size_t speed_queries = std::size_t{1} << 17;
inline constexpr int speed_repetitions = 21;

struct KernelSpeed {
  double scalar_ns = 0, least_scalar_ns = 0;                  // a query: the median of the repetitions, and the least
  std::optional<std::pair<std::string, double>> best_target;  // the best instruction set, where it has one, and its ns
};

// One thread; verdicts alone.
template <class Real>
std::vector<KernelSpeed> measure_speed(const std::vector<const Kernel*>& kernels, int repetitions = speed_repetitions);

}  // namespace axiscert
