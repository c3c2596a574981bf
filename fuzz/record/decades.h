// Counts of sizes by powers of ten.
#pragma once

#include <cstddef>
#include <string>

#include "fuzz/fields/sparse.h"

namespace axiscert {
// Decades of depths, and of other shares of the scene: 0 is exactly zero, as of bodies that touch; 1 is all else below
// 10^-20, too small for a double or not; then [10^k, 10^(k+1)) for k from -20 on; the last one is a share of 1 or more.
// Share and power of ten are the nearest binary64 of each.
inline constexpr int least_decade = -20;
inline constexpr std::size_t decade_count = 2 - least_decade + 1;
std::size_t decade_of(double depth);
// "zero", "less", "-20" ... "-1", "0".
std::string decade_name(std::size_t decade);

struct Decades {
  static constexpr std::size_t size = decade_count;
  static std::string name(std::size_t decade) { return decade_name(decade); }
  static constexpr std::string_view about =
      "Counts by decade: k is depths, or other shares of the scene, from 10^k to below 10^(k+1), zero exactly that, as "
      "of "
      "touching, less all others below 10^-20, too small for a double or not. Each and the power of ten are the "
      "nearest "
      "binary64. A decade without a count is not written.";
};
using DecadeCounts = SparseCounts<Decades>;

}  // namespace axiscert
