// The relative distance of a query from the boundary between contact and separation; a number without a unit.
#pragma once

#include "exact/numbers/exact_depth.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// |d - r| / max(|A-P|, |B-P|, |C-P|, r): Euclidean lengths of exact values, with d the exact distance, whose square is
// `squared_distance`; rounded once, to the nearest binary64. 0 if the divisor is 0.
template <class Real>
double depth(const Query<Real>& q, const Rational& squared_distance);

// The same before rounding.
template <class Real>
ExactDepth exact_depth(const Query<Real>& q, const Rational& squared_distance);

// Bounds of the result of depth(), from an enclosure of d; nothing exact is computed. No depth exceeds 1, since d is at
// most |A-P|: the bounds are [0, 1] if no tighter ones are certain.
struct DepthRange {
  double low = 0, high = 1;
};
template <class Real>
DepthRange depth_range(const Query<Real>& q);

}  // namespace axiscert
