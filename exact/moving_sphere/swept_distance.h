// The exact distance of the centre's path from the triangle, by CGAL.
#pragma once

#include "exact/numbers/rational.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert::moving_sphere {

// The squared distance of the triangles ABC and (P, P + D, P + D): the second is the path, as CGAL 5.5 has no distance
// of a segment from a triangle. For every query of finite numbers; `r` is not read.
Rational swept_squared_distance(const MovingQuery<double>& q);

// The sign of swept_squared_distance(q) - r^2. The radius is not negative.
int swept_distance_order(const MovingQuery<double>& q);

}  // namespace axiscert::moving_sphere
