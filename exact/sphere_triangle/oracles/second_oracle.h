// A second opinion on every decision: MPFR, at a precision at which no operation rounds, and a walk over the triangle's
// features in place of CGAL.
#pragma once

#include "kernel/sphere_triangle/forms/evaluate.h"

namespace axiscert {
// The distance from the origin to a triangle by a walk over its features, in any exact ring. It shares nothing with the
// separating-axis formulae or with CGAL.

// A non-negative numerator over a positive denominator.
template <class T>
struct Ratio {
  T numerator, denominator;
};

// The squared distance to the closed triangle abc, degenerate or not (`rr` is not read): to the plane if the foot of
// the perpendicular lies inside, else the least of the distances to the three segments. Nothing is divided; degree 6
// over degree 4 at most. `order(x, y)` is the sign of x - y; `zero` and `one` are elements of the ring.
template <class T, class Order>
Ratio<T> walked_squared_distance(const portable::CentredProblem<T>& q, const T& zero, const T& one, Order&& order) {
  using portable::cross;
  using portable::dot;
  const auto sign = [&](const T& x) { return order(x, zero); };
  const Vec3<T> normal = cross(q.b - q.a, q.c - q.a);
  const T normal2 = dot(normal, normal);
  if (sign(normal2) > 0 && sign(dot(cross(q.a, q.b), normal)) >= 0 && sign(dot(cross(q.b, q.c), normal)) >= 0 &&
      sign(dot(cross(q.c, q.a), normal)) >= 0) {
    const T height = dot(q.a, normal);
    return {height * height, normal2};
  }
  const auto segment = [&](const Vec3<T>& x, const Vec3<T>& y) -> Ratio<T> {
    const Vec3<T> u = y - x;
    const T along = zero - dot(x, u), length2 = dot(u, u);
    if (sign(along) <= 0) return {dot(x, x), one};
    if (order(along, length2) >= 0) return {dot(y, y), one};
    return {dot(x, x) * length2 - along * along, length2};
  };
  Ratio<T> least = segment(q.a, q.b);
  for (const Ratio<T>& other : {segment(q.b, q.c), segment(q.c, q.a)}) {
    if (order(other.numerator * least.denominator, least.numerator * other.denominator) < 0) least = other;
  }
  return least;
}

struct SecondOpinion {
  SignBits strict, ties;
  int distance_order;  // sign of distance^2 - r^2
};

// For every valid query. Throws HarnessFault if an operation rounds nevertheless.
template <class Real>
SecondOpinion second_opinion(const Query<Real>& q);

}  // namespace axiscert
