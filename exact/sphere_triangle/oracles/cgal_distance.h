// CGAL's exact point-triangle distance, used by the geometric oracle and by its planted fault. Expensive to include.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"

namespace axiscert {

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

template <class Real>
Epeck::Point_3 cgal_point(const Vec3<Real>& v) {
  return Epeck::Point_3(v.x, v.y, v.z);
}

template <class Real>
Epeck::Triangle_3 cgal_triangle(const Query<Real>& q) {
  return Epeck::Triangle_3(cgal_point(q.a), cgal_point(q.b), cgal_point(q.c));
}

template <class Real>
Epeck::FT cgal_squared_distance(const Query<Real>& q) {
  return CGAL::squared_distance(cgal_point(q.p), cgal_triangle(q));
}

template <class Real>
Epeck::FT cgal_squared_radius(const Query<Real>& q) {
  const Epeck::FT r(static_cast<double>(q.r));
  return r * r;
}

template <class Real>
Rational rational_squared_distance(const Query<Real>& q) {
  const Epeck::FT distance = cgal_squared_distance(q);  // outlives the reference into it
  return CGAL::exact(distance);
}

}  // namespace axiscert
