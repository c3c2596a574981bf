// The time that a kernel takes for a verdict: the only figure of an instrument that differs from run to run.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/campaign/progress.h"
#include "kernel/kernel.h"

namespace axiscert {

// 2^17 distinct queries of family `general`, more than the caches of one core can hold; each kernel answers them once
// in every repetition, so that a temporary slowdown of the machine affects all of them.
inline constexpr std::size_t speed_queries = std::size_t{1} << 17;
inline constexpr int speed_repetitions = 21;

struct KernelSpeed {
  // per query: the median and the least over the repetitions
  double scalar_ns = 0, least_scalar_ns = 0;
  std::optional<std::pair<std::string, double>> best_target;  // the best instruction set, if there is one, and its ns
};

// Measured on one thread; verdicts only.
template <class Real>
std::vector<KernelSpeed> measure_speed(const std::vector<const Kernel*>& kernels, int repetitions = speed_repetitions,
                                       const ShowProgress& report = {});

}  // namespace axiscert
