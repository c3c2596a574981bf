// The queries that a search for errors and for scales is about: the box of Goal::error (fuzz/search/method.h), and
// shapes on which range alone is to blame.
#pragma once

#include <optional>
#include <vector>

#include "fuzz/search/method.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// The box for which bounds are proved: every coordinate of A - P, B - P and C - P in [-1, 1] and r in [0, 1], with P
// free, so that an error has the rounding of the translation in it.

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

// The scale at which a comparison leaves the range of its precision.

// Whether range alone can be to blame for a query's result: the query is far from every change of sign
// (fuzz/sphere_triangle/formulae/axis_windows.h), its radius is at least 1/8 of its greatest translated coordinate, and
// so is, for each vertex and each edge, the greatest of its coordinates. Without that the least scale would not be a
// property of the formulae: an edge can be arbitrarily short compared with the rest.
template <class Real>
bool has_good_shape(const Query<Real>& q);

// For each query the exponent m nearest to 0, m > 0 for Goal::overflow and m < 0 for Goal::underflow, at which the
// comparison's bit differs from that at m = 0, or a side is not finite. Both sides of a comparison are homogeneous:
// with unbounded exponents its bit is the same at every scale. Empty if no such m is scanned or 2^m q loses bits
// before, and for a query without a good shape. The kernel has to expose its sides.
template <class Real>
std::vector<std::optional<int>> range_left(const Implementation<Real>& kernel, const Aim& aim,
                                           const QueryBatch<Real>& batch);

// A positive score, greater for an exponent nearer to 0; and the exponent of a score.
double range_score(Goal goal, Precision precision, int exponent);
int range_exponent(Goal goal, Precision precision, double score);

}  // namespace axiscert
