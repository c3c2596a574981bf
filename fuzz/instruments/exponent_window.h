// The range of a kernel's formulae: how far a query may be scaled before the kernel's answers change.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Exponents m, both ends included, of the factor 2^m for every coordinate and the radius.
struct ExponentWindow {
  int low, high;
  int width() const { return high - low + 1; }
  bool operator==(const ExponentWindow&) const = default;
};

// Empty for an axis that differs at m = 0 already.
using AxisWindows = std::array<std::optional<ExponentWindow>, axis_count>;

// Whether all sixteen margins are at least 1/32 of their sides, with the margins of side comparisons measured as
// angles: cosines of at least 1/32. Exact.
template <class Real>
bool is_far_from_every_change(const Query<Real>& q);

// The 256 reference queries: the first of family `general` at seed 1 that are far from every change of sign.
template <class Real>
std::vector<Query<Real>> window_queries();

// The exponents by which the reference queries can be scaled exactly: all exponents that are scanned.
ExponentWindow scanned_exponents(Precision precision);

// For each axis, the greatest interval around 0 in which, on all reference queries, the comparison bits of the axis are
// those that the same operations give with an unbounded exponent, and none of its sides is infinite or NaN. The kernel
// has to expose its comparisons.
template <class Real>
AxisWindows exponent_windows(const Kernel& kernel);

}  // namespace axiscert
