// The size of an absolute number in a kernel, an epsilon, clamp or threshold: estimated from queries that it has right
// at one scale and wrong at another. A message needs it; no count depends on it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "fuzz/campaign/campaign.h"

namespace axiscert {

// A clear base that is answered rightly times 2^right and wrongly times 2^wrong.
struct UnitFlip {
  std::uint64_t base;  // position
  Verdict truth;
  int right, wrong;
};
inline constexpr std::size_t most_unit_flips = 256;

// Asks the kernel between the two powers of each flip until they are neighbours.
void narrow(const Plan& plan, const Kernel& kernel, const Source& source, Precision precision,
            std::vector<UnitFlip>& flips);

// Something of a query with a size, that multiplies by s^degree where every number is multiplied by s.
struct Quantity {
  std::string_view text;
  int degree;
};
inline constexpr std::array<Quantity, 18> quantities = {{{"the distance d", 1},
                                                         {"r", 1},
                                                         {"|d - r|", 1},
                                                         {"|d^2 - r^2|", 2},
                                                         {"|AB x AC|", 2},
                                                         {"the shortest edge", 1},
                                                         {"the edge next to P", 1},
                                                         {"the longest edge", 1},
                                                         {"the distance from P to the nearest vertex", 1},
                                                         {"the distance from P to the farthest vertex", 1},
                                                         {"the greatest coordinate", 1},
                                                         {"the least determinant of P with an edge and the normal", 4},
                                                         {"AP . (AB x AC)", 3},
                                                         {"(AP . V)^2 - r^2 V^2, with V = AB x AC", 6},
                                                         {"the distance to the plane", 1},
                                                         {"AB", 1},
                                                         {"BC", 1},
                                                         {"CA", 1}}};

// A number with which the quantity was compared: all that is known is that it lies between two values.
struct AbsoluteSize {
  std::size_t quantity;
  double least, greatest;
  std::uint64_t explains;  // flips for which the quantity passes the number between `right` and `wrong`
};

// The quantities that explain most of the flips, at least three quarters of them; three at most, in the order above.
// None for a test other than the first, whose quantities these are.
std::vector<AbsoluteSize> absolute_sizes(const Plan& plan, const Source& source, Precision precision,
                                         std::span<const UnitFlip> flips);

}  // namespace axiscert
