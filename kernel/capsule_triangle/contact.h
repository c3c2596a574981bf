// The numbers beside the verdict of a capsule and a triangle, in floats: by the nearest points of its segment and the
// triangle, and where these cross by the shortest push out of what they sweep together. Nothing is certified here.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "kernel/boxes/names.h"
#include "kernel/capsule_triangle/capsule.h"
#include "kernel/moving_sphere/segment.h"

namespace axiscert::capsule {

using moving_sphere::Segment;

// The point of the segment, and that of the triangle.
template <class Real>
struct NearPoints {
  Point<Real> a = {}, b = {};
  Real squared = std::numeric_limits<Real>::infinity();

  // A NaN is taken by nothing.
  void offer(const Point<Real>& of_a, const Point<Real>& of_b) {
    const Point<Real> between = of_b - of_a;
    if (const Real found = dot(between, between); found < squared) *this = {of_a, of_b, found};
  }
};

// At an end of the segment or on an edge of the triangle.
template <class Real>
NearPoints<Real> near_points(const EndsQuery<Real>& q) {
  NearPoints<Real> found;
  for (const Point<Real>& end : {q.p, q.p1}) found.offer(end, end + nearest_from(q, end));
  const Point<Real> along = q.p1 - q.p;
  for (const auto& [from, to] : {std::pair(q.a, q.b), std::pair(q.b, q.c), std::pair(q.c, q.a)}) {
    const auto [s, t] = Segment::nearest_shares<Real>(along, from - q.p, to - q.p);
    found.offer(q.p + along * s, from + (to - from) * t);
  }
  return found;
}

// The unit vector along which the triangle leaves the segment soonest, and how far it goes.
template <class Real>
struct LeastPush {
  Point<Real> normal = {0, 0, 1};
  Real length = std::numeric_limits<Real>::infinity();

  void offer(const EndsQuery<Real>& q, const Point<Real>& direction) {
    const Real size = std::sqrt(dot(direction, direction));
    if (!(size > 0)) return;
    for (const Point<Real>& unit : {direction * (1 / size), direction * (-1 / size)}) {
      const Real reach = std::max(Real(0), dot(unit, q.p1 - q.p)) -
                         std::min({dot(unit, q.a - q.p), dot(unit, q.b - q.p), dot(unit, q.c - q.p)});
      if (reach < length) normal = unit, length = reach;
    }
  }
};
template <class Real>
LeastPush<Real> least_push(const EndsQuery<Real>& q) {
  LeastPush<Real> found;
  const Point<Real> along = q.p1 - q.p;
  found.offer(q, cross(q.b - q.a, q.c - q.a));
  for (const Point<Real>& edge : {q.b - q.a, q.c - q.b, q.a - q.c}) found.offer(q, cross(along, edge));
  if (found.length < std::numeric_limits<Real>::infinity()) return found;
  // All on one line, or in one point.
  Point<Real> line = along;
  for (const Point<Real>& edge : {q.b - q.a, q.c - q.b}) {
    if (dot(edge, edge) > dot(line, line)) line = edge;
  }
  for (const Point<Real>& unit : {Point<Real>{1, 0, 0}, Point<Real>{0, 1, 0}}) found.offer(q, cross(line, unit));
  if (!(found.length < std::numeric_limits<Real>::infinity())) found.length = 0;
  return found;
}

// Measures in their order. The sign of the separation is that of the verdict, from which it may differ by a rounding.
template <class Real>
void put_contact(const EndsQuery<Real>& q, bool is_separated, Real* out) {
  NearPoints<Real> near = near_points(q);
  const bool crosses = !is_separated && Segment::crosses<Real>(q.p1 - q.p, q.a - q.p, q.b - q.p, q.c - q.p);
  Real distance = crosses ? Real(0) : std::sqrt(near.squared);
  Point<Real> normal = (near.b - near.a) * (1 / distance);
  if (!(distance > 0)) {
    const LeastPush<Real> push = least_push(q);
    const Point<Real> way = push.normal * push.length;
    near = near_points(EndsQuery<Real>{q.a + way, q.b + way, q.c + way, q.p, q.p1, q.r});
    near.b = near.b - way;
    normal = push.normal;
    distance = -push.length;
  }
  const Real separation = distance - q.r;
  const Point<Real> surface = near.a + normal * q.r;
  out[boxes::separation_measure] = is_separated ? std::max(separation, Real(0)) : std::min(separation, Real(0));
  const std::pair<std::size_t, Point<Real>> vectors[] = {
      {boxes::normal_measure, normal}, {boxes::point_a_measure, surface}, {boxes::point_b_measure, near.b}};
  for (const auto& [first, v] : vectors) {
    out[first] = v.x;
    out[first + 1] = v.y;
    out[first + 2] = v.z;
  }
}

}  // namespace axiscert::capsule
