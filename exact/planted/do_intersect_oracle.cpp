// A planted fault: the geometric oracle that CGAL's do_intersect seems to offer. It takes the sphere as a surface, so a
// triangle wholly inside does not intersect it. The cross-checks have to notice; nothing but tests links this.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Sphere_3.h>
#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

#include "exact/geometric_oracle.h"

namespace axiscert {
namespace {

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

template <class Real>
int order_of(const Query<Real>& q) {
  const auto point = [](const Vec3<Real>& v) { return Epeck::Point_3(v.x, v.y, v.z); };
  const Epeck::Triangle_3 triangle(point(q.a), point(q.b), point(q.c));
  if (triangle.is_degenerate()) return static_cast<int>(CGAL::compare(CGAL::squared_distance(point(q.p), triangle), Epeck::FT(q.r) * Epeck::FT(q.r)));
  return CGAL::do_intersect(Epeck::Sphere_3(point(q.p), Epeck::FT(q.r) * Epeck::FT(q.r)), triangle) ? -1 : 1;
}

template <class Real>
Rational rational_of(const Query<Real>& q) {
  const auto point = [](const Vec3<Real>& v) { return Epeck::Point_3(v.x, v.y, v.z); };
  const Epeck::FT distance = CGAL::squared_distance(point(q.p), Epeck::Triangle_3(point(q.a), point(q.b), point(q.c)));
  return CGAL::exact(distance);
}

}  // namespace

int distance_order(const Query<float>& q) { return order_of(q); }
int distance_order(const Query<double>& q) { return order_of(q); }
Rational squared_distance(const Query<float>& q) { return rational_of(q); }
Rational squared_distance(const Query<double>& q) { return rational_of(q); }

}  // namespace axiscert
