// Geometric truth G: the distance from a point to a triangle by CGAL, which shares no formula with the kernels.
#pragma once

#include "exact/numbers/rational.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// The sign of (distance^2 - r^2), both exact: -1 overlap, 0 touching, 1 separated. For every valid query.
int distance_order(const Query<float>& q);
int distance_order(const Query<double>& q);

// The exact squared distance between p and the closed triangle abc.
Rational squared_distance(const Query<float>& q);
Rational squared_distance(const Query<double>& q);

}  // namespace axiscert
