#include "exact/moving_sphere/swept_distance.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Quotient.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

// The distance of two triangles, degenerate ones included, was compared with least_distance() in this version alone.
static_assert(CGAL_VERSION_NR >= 1050500000 && CGAL_VERSION_NR < 1050600000, "axiscert is tested with CGAL 5.5");

namespace axiscert::moving_sphere {
namespace {

using SweptKernel = CGAL::Exact_predicates_exact_constructions_kernel;

template <class K>
typename K::FT swept_distance(const GivenMotion& q, double until = 1) {
  const auto point = [](const portable::Vec3<double>& v) { return typename K::Point_3(v.x, v.y, v.z); };
  const typename K::Point_3 from = point(q.p);
  typename K::Vector_3 way = q.to_is_end ? point(q.to) - from : point(q.to) - CGAL::ORIGIN;
  if (until != 1) way = way * typename K::FT(until);
  const typename K::Point_3 to = from + way;
  return CGAL::squared_distance(typename K::Triangle_3(point(q.a), point(q.b), point(q.c)),
                                typename K::Triangle_3(from, to, to));
}

}  // namespace

Rational swept_squared_distance(const GivenMotion& q) {
  const SweptKernel::FT distance = swept_distance<SweptKernel>(q);  // outlives the reference into it
  return CGAL::exact(distance);
}

// Intervals would never decide: the triangle of a path has two equal corners, and CGAL asks whether its sides are
// parallel. Quotients of binary numbers have no common divisors to look for.
int swept_distance_order(const GivenMotion& q, double until) {
  using Exact = CGAL::Quotient<CGAL::Mpzf>;
  const Exact r(q.r);
  return static_cast<int>(CGAL::compare(swept_distance<CGAL::Simple_cartesian<Exact>>(q, until), Exact(r * r)));
}

}  // namespace axiscert::moving_sphere
