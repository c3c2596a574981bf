// A planted fault: the geometric oracle that CGAL's do_intersect seems to offer. It treats the sphere as a surface, so
// a triangle wholly inside does not intersect it. The cross-checks have to detect that; only tests link this file.
#include <CGAL/Sphere_3.h>
#include <CGAL/intersections.h>

#include "exact/sphere_triangle/oracles/cgal_distance.h"

namespace axiscert {
namespace {

template <class Real>
int order_of(const Query<Real>& q) {
  const Epeck::Triangle_3 triangle = cgal_triangle(q);
  if (triangle.is_degenerate()) {  // do_intersect requires a triangle with area
    return static_cast<int>(CGAL::compare(cgal_squared_distance(q), cgal_squared_radius(q)));
  }
  return CGAL::do_intersect(Epeck::Sphere_3(cgal_point(q.p), cgal_squared_radius(q)), triangle) ? -1 : 1;
}

}  // namespace

int distance_order(const Query<float>& q) { return order_of(q); }
int distance_order(const Query<double>& q) { return order_of(q); }
Rational squared_distance(const Query<float>& q) { return rational_squared_distance(q); }
Rational squared_distance(const Query<double>& q) { return rational_squared_distance(q); }

}  // namespace axiscert
