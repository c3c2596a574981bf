// Images of a query in other units of length: times powers of two within the range of forms of degree 6.
#pragma once

#include "fuzz/queries/image_groups.h"

namespace axiscert::unit_images {

// The base, times the least power, times the greatest, and times one of each fifth of the others in turn.
inline constexpr std::size_t count = 8;

constexpr int exponent(const PowerRange& range, std::uint64_t base, std::size_t image) {
  constexpr std::size_t ends = 3;
  if (image == 0) return 0;
  if (image < ends) return image == 1 ? range.least : range.greatest;
  // The powers between the ends but 1, by number from below.
  const auto others = static_cast<std::uint64_t>(range.greatest - range.least - 2);
  const std::uint64_t part = image - ends, parts = count - ends;
  const std::uint64_t first = part * others / parts, after = (part + 1) * others / parts;
  const int power = range.least + 1 + static_cast<int>(first + base % (after - first));
  return power < 0 ? power : power + 1;
}

}  // namespace axiscert::unit_images
