// CGAL without its exactness: squared_distance(point, triangle) over Simple_cartesian of a floating-point type,
// compared with r r in that type. Known for CGAL 5.5. Not a use that CGAL advises, and a common one.
//
// Degree 6 over degree 4, rounded at each operation: in float it overflows and underflows, in double it is right on
// most binary32 queries, but not on all: docs/league.md has ones. Tracker: cgal 5680, 6359, 7147, 8146.
#pragma once

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include "kernel/peers/peer.h"

namespace axiscert::peer {

template <class Number>
struct CgalInexact {
  using Real = Number;
  // The comparison is ours, so distance <= radius is contact.
  static constexpr axiscert_touching touching = AXISCERT_TOUCHING_IS_CONTACT;

  int operator()(const Query<Number>& q) const {
    using Kernel = CGAL::Simple_cartesian<Number>;
    const auto point = [](const Vec3<Number>& v) { return typename Kernel::Point_3(v.x, v.y, v.z); };
    const typename Kernel::Triangle_3 triangle(point(q.a), point(q.b), point(q.c));
    return verdict_within<Number>(CGAL::squared_distance(point(q.p), triangle), q.r * q.r);
  }
};

}  // namespace axiscert::peer
