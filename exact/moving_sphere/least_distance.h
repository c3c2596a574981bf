// The least distance of a moving centre from a triangle, in integers and rationals, without a root. It shares nothing
// with the twenty axes or with CGAL.
#pragma once

#include "exact/moving_sphere/given_motion.h"
#include "exact/numbers/rational.h"

namespace axiscert::moving_sphere {

struct LeastDistance {
  Rational squared;       // the least over t in [0, 1] of |P + t D - X|^2, X in the closed triangle ABC
  bool crosses_the_face;  // the centre passes through the plane of ABC strictly inside ABC, strictly between 0 and 1
};

// For every query of finite numbers, any triangle and any D; `r` is not read.
//
// The squared distance is, over t, one quadratic a t^2 - 2 b t + c on each interval in which the nearest feature is the
// same. A feature's interval is where linear functions of t, its gates, are not negative; the intervals cover [0, 1]
// together, since a triangle's Voronoi regions are bounded by planes. So the least is at an end of such an interval or
// at b / a in it, all of which are rational.
LeastDistance least_distance(const GivenMotion& q);

}  // namespace axiscert::moving_sphere
