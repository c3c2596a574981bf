// How far a query may be scaled before a kernel's answers change: the range of its formulae.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert {

// Exponents m, both ends included, of the factor 2^m on every coordinate and the radius.
struct ExponentWindow {
  int low, high;
  int width() const { return high - low + 1; }
  bool operator==(const ExponentWindow&) const = default;
};

// Nothing where the axis differs at m = 0 already.
using AxisWindows = std::array<std::optional<ExponentWindow>, axis_count>;

// All sixteen margins are at least 1/32 of their sides, the signs of the side comparisons taken as angles: cosines of
// 1/32 at least. Exact.
template <class Real>
bool is_far_from_every_change(const Query<Real>& q);

// The 256 reference queries: the first of family `general` at seed 1 that are far from every change of sign.
template <class Real>
std::vector<Query<Real>> window_queries();

// The exponents by which the reference queries can be multiplied exactly: all that is scanned.
ExponentWindow scanned_exponents(Precision precision);

// By axis, the greatest interval around 0 in which, on all reference queries, the comparison bits of the axis are those
// that the same operations give with an unbounded exponent, and none of its sides is infinite or NaN. The kernel shows
// its comparisons.
template <class Real>
AxisWindows exponent_windows(const Kernel& kernel);

}  // namespace axiscert
