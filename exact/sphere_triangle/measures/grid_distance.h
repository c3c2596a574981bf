// The distance and the depth of a query by integers, rounded once, without CGAL and without rationals.
#pragma once

#include <optional>

#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// The result of depth() for a valid query; empty if the exact depth is a midpoint of two doubles or too near to one.
template <class Real>
std::optional<double> depth_on_grid(const Query<Real>& q);

// The distance from P to the triangle, rounded to nearest: infinite beyond the precision. Empty if it is a midpoint of
// two floats or too near to one. For a valid query, whatever its r.
template <class Real>
std::optional<Real> distance_on_grid(const Query<Real>& q);

}  // namespace axiscert
