// A second opinion on everything: MPFR, at a precision at which no operation rounds, and a walk over the triangle's
// features in place of CGAL.
#pragma once

#include <algorithm>

#include "kernel/evaluate.h"

namespace axiscert {

struct SecondOpinion {
  ComparisonBits strict, ties;
  int distance_order;  // sign of distance^2 - r^2
};

// For every valid query. Throws HarnessFault should an operation round after all.
template <class Real>
SecondOpinion second_opinion(const Query<Real>& q);

// The sign of (distance^2 - rr) between the origin and the closed triangle abc, degenerate or not, over any exact ring;
// `order(x, y)` is the sign of x - y. It is the least of the signs over three segments and, where the foot of the
// perpendicular lies inside, the plane. Cross-multiplied, so nothing is divided.
template <class T, class Order>
int distance_order(const portable::Centred<T>& q, const T& zero, Order&& order) {
  using portable::cross;
  using portable::dot;
  const auto sign = [&](const T& x) { return order(x, zero); };
  const auto segment = [&](const Vec3<T>& x, const Vec3<T>& y) {
    const Vec3<T> u = y - x;
    const T along = zero - dot(x, u), length2 = dot(u, u);
    if (sign(along) <= 0) return order(dot(x, x), q.rr);
    if (order(along, length2) >= 0) return order(dot(y, y), q.rr);
    return order(dot(x, x) * length2 - along * along, q.rr * length2);
  };
  int least = segment(q.a, q.b);
  least = std::min(least, segment(q.b, q.c));
  least = std::min(least, segment(q.c, q.a));
  const Vec3<T> normal = cross(q.b - q.a, q.c - q.a);
  const T normal2 = dot(normal, normal);
  const bool has_area = sign(normal2) > 0;
  const bool foot_inside = sign(dot(cross(q.a, q.b), normal)) >= 0 && sign(dot(cross(q.b, q.c), normal)) >= 0 &&
                           sign(dot(cross(q.c, q.a), normal)) >= 0;
  if (has_area && foot_inside) {
    const T height = dot(q.a, normal);
    least = std::min(least, order(height * height, q.rr * normal2));
  }
  return least;
}

}  // namespace axiscert
