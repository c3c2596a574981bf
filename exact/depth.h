// How far a query is from the boundary between contact and separation, free of units.
#pragma once

#include "exact/rational.h"
#include "kernel/query.h"

namespace axiscert {

// |d - r| / max(|A-P|, |B-P|, |C-P|, r): Euclidean lengths of exact values, d the exact distance whose square is
// `squared_distance`; rounded once, to the nearest binary64. 0 where the divisor is 0.
template <class Real>
double depth(const Query<Real>& q, const Rational& squared_distance);

}  // namespace axiscert
