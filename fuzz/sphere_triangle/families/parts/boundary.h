// Solves a query onto a boundary: the float nearest to the exact root of a margin.
#pragma once

#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// The radius comparison of an axis.
constexpr Comparison radius_comparison(Axis axis) {
  std::size_t i = 0;
  while (comparisons[i].axis != axis || !comparisons[i].is_radius) ++i;
  return static_cast<Comparison>(i);
}

// The Real nearest to the radius at which a radius comparison is a tie: sqrt(lhs / rhs at r = 1), correctly rounded.
// Zero if the comparison ties for every radius (a zero-area triangle's plane, a repeated vertex's edge).
template <class Real>
Real radius_on_boundary(const Query<Real>& q, Comparison which);

// The Real nearest to the exact distance between p and the triangle: the verdict's own boundary.
template <class Real>
Real radius_at_distance(const Query<Real>& q);

// The Real nearest to the value of one coordinate of p (0, 1 or 2) at which a side comparison is a tie, with the others
// unchanged. Every side margin is affine in each coordinate of p, so there is one root; if the margin does not depend
// on the coordinate, the result is the coordinate's given value.
template <class Real>
Real coordinate_on_boundary(const Query<Real>& q, Comparison side_comparison, int coordinate);

// The same three by exact arithmetic alone, with the same values; used if the filters of
// exact/sphere_triangle/measures/nearest_root.h give no result.
template <class Real>
Real exact_radius_on_boundary(const Query<Real>& q, Comparison which);
template <class Real>
Real exact_radius_at_distance(const Query<Real>& q);
template <class Real>
Real exact_coordinate_on_boundary(const Query<Real>& q, Comparison side_comparison, int coordinate);

}  // namespace axiscert
