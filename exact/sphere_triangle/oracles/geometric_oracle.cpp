#include "exact/sphere_triangle/oracles/geometric_oracle.h"

#include "exact/sphere_triangle/oracles/cgal_distance.h"

// CGAL's point-triangle distance has been wrong in a release (5.4 beta). The tests check this version against two other
// computations, and this assertion keeps another version from being used unnoticed.
static_assert(CGAL_VERSION_NR >= 1050500000 && CGAL_VERSION_NR < 1050600000, "axiscert is tested with CGAL 5.5");

namespace axiscert {
namespace {

// Not do_intersect(Sphere_3, Triangle_3), which treats the sphere as a surface; and r r is formed exactly, unlike in
// EPICK's compare_squared_distance_3(p, t, r * r) for binary64.
template <class Real>
int order_of(const Query<Real>& q) {
  return static_cast<int>(CGAL::compare(cgal_squared_distance(q), cgal_squared_radius(q)));
}

}  // namespace

int distance_order(const Query<float>& q) { return order_of(q); }
int distance_order(const Query<double>& q) { return order_of(q); }
Rational squared_distance(const Query<float>& q) { return rational_squared_distance(q); }
Rational squared_distance(const Query<double>& q) { return rational_squared_distance(q); }

}  // namespace axiscert
