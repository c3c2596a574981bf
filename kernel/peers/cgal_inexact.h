// CGAL without exactness: squared_distance(point, triangle) over Simple_cartesian of a floating-point type, compared
// with r r in that type. The description applies to CGAL 5.5. CGAL does not advise this use, but it is common.
//
// The distance is a quotient of degree 6 over degree 4, rounded at each operation: in float it overflows and
// underflows; in double it is right on most binary32 queries, but not on all: docs/league.md has examples. Tracker:
// cgal 5680, 6359, 7147, 8146.
#pragma once

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include "kernel/peers/peer.h"

namespace axiscert::peer {

template <class Number>
struct CgalInexact {
  using Real = Number;
  // The root of what it gives, less the radius, beside both verdicts.
  static constexpr std::size_t measure_count = separation_alone;
  // The comparison is made here, so distance <= radius is contact.
  static constexpr axiscert_touching touching = AXISCERT_TOUCHING_IS_CONTACT;

  int operator()(const Query<Number>& q, Contact<Number>& said) const {
    using Kernel = CGAL::Simple_cartesian<Number>;
    const auto point = [](const Vec3<Number>& v) { return typename Kernel::Point_3(v.x, v.y, v.z); };
    const typename Kernel::Triangle_3 triangle(point(q.a), point(q.b), point(q.c));
    const Number squared = CGAL::squared_distance(point(q.p), triangle);
    said.separation = std::sqrt(squared) - q.r;
    return verdict_within<Number>(squared, q.r * q.r);
  }
};

}  // namespace axiscert::peer
