// How far a query is from the boundary between contact and separation, free of units.
#pragma once

#include "exact/numbers/rational.h"
#include "kernel/query.h"

namespace axiscert {

// |d - r| / max(|A-P|, |B-P|, |C-P|, r): Euclidean lengths of exact values, d the exact distance whose square is
// `squared_distance`; rounded once, to the nearest binary64. 0 where the divisor is 0.
template <class Real>
double depth(const Query<Real>& q, const Rational& squared_distance);

// The same before it is rounded, |sqrt(dd) - r| / sqrt(ss), as the rationals that it is made of; ss > 0.
struct ExactDepth {
  Rational dd, r, ss;
};
template <class Real>
ExactDepth exact_depth(const Query<Real>& q, const Rational& squared_distance);
// The sign of x - y.
int compare(const ExactDepth& x, const ExactDepth& y);

// Bounds of what depth() returns, from an enclosure of d; nothing exact is computed. No depth exceeds 1, since d is at
// most |A-P|: [0, 1] where nothing more is certain.
struct DepthRange {
  double low = 0, high = 1;
};
template <class Real>
DepthRange depth_range(const Query<Real>& q);

}  // namespace axiscert
