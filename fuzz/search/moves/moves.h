// The moves of a search from one query to the next. Only integers, sums, products and quotients: the same everywhere.
#pragma once

#include "fuzz/search/moves/dice.h"
#include "fuzz/queries/query_shape.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Whether the real number a - p is at most 1 in magnitude, exactly.
template <class Real>
bool is_within_one(Real a, Real p);
// Whether a query is in the box of Goal::error: every coordinate of A - P, B - P, C - P in [-1, 1], exactly, and r
// <= 1.
template <class Real>
bool is_in_box(const Query<Real>& q);

// Brings a query into the box of Goal::error: |coordinates of A - P, B - P, C - P| <= 1 exactly, 0 <= r <= 1, every
// number finite, the greatest of these at least 1/2 unless all are zero or P is too far away for that. Coordinates
// beyond the box are moved to its boundary; a smaller scene is scaled by a power of two.
template <class Real>
void settle(Query<Real>& q);

// The same for a query of any other test: every number finite and at most 2^8 in magnitude, so that formulae of degree
// 6 keep to the normal numbers, lengths not negative, and the greatest number at least 1/2 unless all are zero. The
// axes of a box that are not a rotation but for roundings are made one, since no test of boxes is right for others.
template <class Real>
void settle(const QueryShape& shape, Numbers<Real>& q);

// One random move: numbers changed by ulps, random low bits, exponents, signs; numbers copied, swapped or replaced; the
// whole scene moved to a new centre, with the translated vertices unchanged; vertices, directions, axes of the box,
// blends with `other`; the axes of a box turned a little, or taken from the other box. The result is not settled.
template <class Real>
void move(Dice& random, const QueryShape& shape, Numbers<Real>& q, const Numbers<Real>& other);
template <class Real>
void move(Dice& random, Query<Real>& q, const Query<Real>& other);

// The shape of a query of sphere-triangle.
const QueryShape& sphere_triangle_shape();

// Moves one number by `ulps` steps, for refining the least significant bits of a result; negative steps go downwards.
template <class Real>
Real moved_by_ulps(Real x, std::int64_t ulps);

}  // namespace axiscert
