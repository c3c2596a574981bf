// The float nearest to an exact distance, or to the value of a number at which a comparison is a tie, without exact
// arithmetic: certain, or nothing.
#pragma once

#include <optional>

#include "kernel/query.h"

namespace axiscert {

// Each is the correctly rounded value, by an enclosure in which both neighbouring rounding midpoints are excluded
// strictly: in double for binary32, in double-double where that does not tell and for binary64. Nothing where that does
// not tell either, such as for a root of zero that is not seen from the numbers themselves. Of valid queries; r is not
// read.

// The distance between p and the triangle abc, degenerate or not.
template <class Real>
std::optional<Real> nearest_distance(const Query<Real>& q);

// sqrt(lhs / rhs at r = 1) of a radius comparison; zero where rhs is zero.
template <class Real>
std::optional<Real> nearest_tie_radius(const Query<Real>& q, Comparison radius_comparison);

// The value of one coordinate of p (0, 1 or 2) at which a side comparison is a tie; the coordinate's own where the
// margin does not depend on it.
template <class Real>
std::optional<Real> nearest_tie_coordinate(const Query<Real>& q, Comparison side_comparison, int coordinate);

}  // namespace axiscert
