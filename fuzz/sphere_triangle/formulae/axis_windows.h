// The range of a kernel's formulae: how far a query may be scaled before the kernel's answers change.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fuzz/queries/image_groups.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Empty for an axis that differs at m = 0 already.
using AxisWindows = std::array<std::optional<ExponentWindow>, axis_count>;

// Whether all sixteen margins are at least 1/32 of their sides, with the margins of side comparisons measured as
// angles: cosines of at least 1/32. Exact.
template <class Real>
bool is_far_from_every_change(const Query<Real>& q);

// The 256 reference queries: the first of family `general` at seed 1 that are far from every change of sign. They can
// be scaled exactly by all exponents that are scanned.
template <class Real>
std::vector<Query<Real>> window_queries();

// For each axis, the greatest interval around 0 in which, on all reference queries, the comparison bits of the axis are
// those that the same operations give with an unbounded exponent, and none of its sides is infinite or NaN. The kernel
// has to expose its comparisons.
template <class Real>
AxisWindows exponent_windows(const Kernel& kernel);

}  // namespace axiscert
