// The box of Goal::error (fuzz/search/goal.h), for which bounds are proved: every coordinate of A - P, B - P and C - P
// in
// [-1, 1] and r in [0, 1], with P free, so that an error has the rounding of the translation in it.
#pragma once

#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Whether the real number a - p is at most 1 in magnitude, exactly.
template <class Real>
bool is_within_one(Real a, Real p);
// Whether a valid query is in the box, exactly.
template <class Real>
bool is_in_box(const Query<Real>& q);

// Brings a query into the box, every number finite, the greatest of r and the translated coordinates at least 1/2
// unless all are zero or P is too far away for that. Coordinates beyond the box are moved to its boundary; a smaller
// scene is scaled by a power of two.
template <class Real>
void settle(Query<Real>& q);

}  // namespace axiscert
