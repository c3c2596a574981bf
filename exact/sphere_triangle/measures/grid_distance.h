// The distance and the depth of a query by integers, rounded once: neither CGAL nor a rational.
#pragma once

#include <optional>

#include "kernel/query.h"

namespace axiscert {

// What depth() returns; nothing where that is too near to the midpoint of two doubles, or on it. Of a valid query.
template <class Real>
std::optional<double> depth_on_grid(const Query<Real>& q);

// The distance from P to the triangle, rounded to nearest: infinite beyond the precision. Nothing where it is too near
// to the midpoint of two floats, or on it. Of a valid query, whatever its r.
template <class Real>
std::optional<Real> distance_on_grid(const Query<Real>& q);

}  // namespace axiscert
