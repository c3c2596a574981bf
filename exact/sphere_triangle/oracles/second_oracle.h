// A second opinion on every decision: MPFR, at a precision at which no operation rounds, and a walk over the triangle's
// features in place of CGAL.
#pragma once

#include "kernel/sphere_triangle/reference/evaluate.h"

namespace axiscert {

struct SecondOpinion {
  SignBits strict, ties;
  int distance_order;  // sign of distance^2 - r^2
};

// For every valid query. Throws HarnessFault if an operation rounds nevertheless.
template <class Real>
SecondOpinion second_opinion(const Query<Real>& q);

}  // namespace axiscert
