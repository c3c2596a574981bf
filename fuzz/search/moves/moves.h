// The moves of a search from one query to the next. Only integers, sums, products and quotients: the same everywhere.
#pragma once

#include "fuzz/search/moves/dice.h"
#include "fuzz/queries/query_shape.h"
#include "kernel/query.h"

namespace axiscert {

// Brings a query to where wrong verdicts are looked for: every number finite and at most 2^8 in magnitude, so that
// formulae of degree 6 keep to the normal numbers, lengths not negative, and the greatest number at least 1/2 unless
// all are zero. The axes of a box that are not a rotation but for roundings are made one, since no predicate of boxes
// is right for others.
template <class Real>
void settle(const QueryShape& shape, Numbers<Real>& q);

// One random move: numbers changed by ulps, random low bits, exponents, signs; numbers copied, swapped or replaced; the
// whole scene moved to a new centre, with the translated vertices unchanged; vertices, directions, axes of the box,
// blends with `other`; the axes of a box turned a little, or taken from the other box. The result is not settled.
template <class Real>
void move(Dice& random, const QueryShape& shape, Numbers<Real>& q, const Numbers<Real>& other);

// Moves one number by `ulps` steps, for refining the least significant bits of a result; negative steps go downwards.
template <class Real>
Real moved_by_ulps(Real x, std::int64_t ulps);

}  // namespace axiscert
