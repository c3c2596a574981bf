// The exact distance of the centre's path from the triangle, by CGAL.
#pragma once

#include "exact/moving_sphere/given_motion.h"
#include "exact/numbers/rational.h"

namespace axiscert::moving_sphere {

// The squared distance of the triangles ABC and (P, P + D, P + D): the second is the path, as CGAL 5.5 has no distance
// of a segment from a triangle. For every query of finite numbers; `r` is not read.
Rational swept_squared_distance(const GivenMotion& q);

// The sign of the same less r^2, of the motion as far as P + until D; `until` is any finite number. The radius is not
// negative. The motion's first contact is at t* or before exactly where this is not positive for until = t*.
int swept_distance_order(const GivenMotion& q, double until = 1);

}  // namespace axiscert::moving_sphere
