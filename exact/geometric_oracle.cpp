#include "exact/geometric_oracle.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

// CGAL's point-triangle distance has been wrong in a release (5.4 beta); this one is checked by the tests against two
// others, and read by no other version unnoticed.
static_assert(CGAL_VERSION_NR >= 1050500000 && CGAL_VERSION_NR < 1060000000, "axiscert is tested with CGAL 5.5 and 5.6");

namespace axiscert {
namespace {

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

// Not do_intersect(Sphere_3, Triangle_3), which takes the sphere as a surface; and r r is formed exactly, which
// EPICK's compare_squared_distance_3(p, t, r * r) does not do for binary64.
template <class Real>
Epeck::FT exact_squared_distance(const Query<Real>& q) {
  const auto point = [](const Vec3<Real>& v) { return Epeck::Point_3(v.x, v.y, v.z); };
  return CGAL::squared_distance(point(q.p), Epeck::Triangle_3(point(q.a), point(q.b), point(q.c)));
}

template <class Real>
int order_of(const Query<Real>& q) {
  const Epeck::FT r(static_cast<double>(q.r));
  return static_cast<int>(CGAL::compare(exact_squared_distance(q), r * r));
}

template <class Real>
Rational rational_of(const Query<Real>& q) {
  const Epeck::FT distance = exact_squared_distance(q);  // outlives the reference into it
  return CGAL::exact(distance);
}

}  // namespace

int distance_order(const Query<float>& q) { return order_of(q); }
int distance_order(const Query<double>& q) { return order_of(q); }
Rational squared_distance(const Query<float>& q) { return rational_of(q); }
Rational squared_distance(const Query<double>& q) { return rational_of(q); }

}  // namespace axiscert
