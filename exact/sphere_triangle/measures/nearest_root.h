// The float nearest to an exact distance, or to the value of a number at which a comparison is a tie, without exact
// arithmetic: certain, or empty.
#pragma once

#include <optional>

#include "kernel/sphere_triangle/query.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {

// Each result is the correctly rounded value, by an enclosure that strictly excludes both neighbouring rounding
// midpoints: in double for binary32, in double-double if that does not decide and for binary64. The result is empty if
// that does not decide either, for example for a root of zero that is not obvious from the numbers themselves. Queries
// must be valid; r is not read.

// The distance between p and the triangle abc, degenerate or not.
template <class Real>
std::optional<Real> nearest_distance(const Query<Real>& q);

// sqrt(lhs / rhs at r = 1) of a radius comparison; zero if rhs is zero.
template <class Real>
std::optional<Real> nearest_tie_radius(const Query<Real>& q, Comparison radius_comparison);

// The value of one coordinate of p (0, 1 or 2) at which a side comparison is a tie; the given coordinate if the margin
// does not depend on it.
template <class Real>
std::optional<Real> nearest_tie_coordinate(const Query<Real>& q, Comparison side_comparison, int coordinate);

}  // namespace axiscert
