// A query of a capsule and a triangle as the formulae see it: ABC, and the points no farther than r from the segment P
// to Q. It is where a sphere of radius r was that moved from P to Q, so the formulae of a moving sphere by its ends are
// its own too (kernel/moving_sphere).
#pragma once

#include <algorithm>

#include "kernel/formulae_kernel.h"
#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/sphere_triangle/forms/methods.h"

namespace axiscert {

const Predicate& capsule_triangle_predicate();

struct Capsule {
  static const Predicate& description() { return capsule_triangle_predicate(); }

  // p1 is Q.
  template <class T>
  using Problem = EndsQuery<T>;
  template <class T, class Load>
  static Problem<T> problem(Load&& load) {
    return MovingEnds::problem<T>(load);
  }
};

}  // namespace axiscert

namespace axiscert::capsule {

// A capsule and a triangle by the nearest points that engines take.

template <class Real>
using Point = portable::Vec3<Real>;

// The triangle's point nearest to `from`, seen from there.
template <class Real>
Point<Real> nearest_from(const EndsQuery<Real>& q, const Point<Real>& from) {
  return methods::ClosestPoint::closest(portable::CentredProblem<Real>{q.a - from, q.b - from, q.c - from, q.r * q.r},
                                        Real(0));
}
// The point of the segment P Q nearest to `at`.
template <class Real>
Point<Real> on_segment(const EndsQuery<Real>& q, const Point<Real>& at) {
  const Point<Real> along = q.p1 - q.p;
  const Real length2 = dot(along, along);
  if (!(length2 > 0)) return q.p;
  return q.p + along * std::clamp(dot(along, at - q.p) / length2, Real(0), Real(1));
}

// One sphere in the place of the capsule: its centre is the segment's point nearest to the triangle's point that is
// nearest to where the capsule's line meets the plane; A, where it is parallel to it. Not right over the reals: where
// the line meets the plane far from the triangle, another point of the segment is nearer.
// Source: the method of J. Turanszki, "Capsule Collision Detection" (2020).
struct ReferencePoint {
  template <class Real>
  static bool separated(const EndsQuery<Real>& q) {
    const Point<Real> along = q.p1 - q.p, normal = cross(q.b - q.a, q.c - q.a);
    const Real towards = dot(normal, along);
    Point<Real> reference = q.a;
    if (towards != 0) {
      const Point<Real> meets = q.p + along * (dot(normal, q.a - q.p) / towards);
      reference = meets + nearest_from(q, meets);
    }
    const Point<Real> nearest = nearest_from(q, on_segment(q, reference));
    return dot(nearest, nearest) > q.r * q.r;
  }
};

// Nearest points in turns: of the triangle to the segment's point, of the segment to the triangle's, from both ends and
// the middle, eight times each. Each turn comes nearer, so it never invents a contact over the reals; along shallow
// angles the turns are too few.
struct Alternating {
  static constexpr int turns = 8;
  template <class Real>
  static bool separated(const EndsQuery<Real>& q) {
    for (const Point<Real>& start : {q.p, q.p1, (q.p + q.p1) * Real(0.5)}) {
      Point<Real> centre = start;
      for (int turn = 0; turn < turns; ++turn) {
        const Point<Real> nearest = nearest_from(q, centre);
        if (dot(nearest, nearest) <= q.r * q.r) return false;
        centre = on_segment(q, centre + nearest);
      }
    }
    return true;
  }
};

}  // namespace axiscert::capsule
