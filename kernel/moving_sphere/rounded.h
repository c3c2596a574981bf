// The moving centre as a segment against the triangle rounded by r, piece by piece: the form that engines use. It has a
// verdict and no comparisons.
#pragma once

#include <cmath>

#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/sphere_triangle/methods/closest_point.h"

namespace axiscert::moving_sphere {

// Contact where the start overlaps, or the centre meets, at a time in [0, 1], the face moved out by r, the inside of an
// edge's cylinder or a vertex's sphere. A time is (b - sqrt(b^2 - a c)) / a, in which both differences cancel; over the
// reals it is right for every triangle with area and D != 0.
// Source: the method of C. Ericson, Real-Time Collision Detection (2005), section 5.3; closest point 5.1.5.
struct Rounded {
  template <class Real>
  static bool separated(const MovingQuery<Real>& q) {
    using portable::cross;
    using portable::dot;
    using Vector = portable::Vec3<Real>;
    const portable::Centred<Real> start{q.a - q.p, q.b - q.p, q.c - q.p, q.r * q.r};
    const auto& [a, b, c, rr] = start;
    const Vector normal = cross(b - a, c - a);
    const Real length = std::sqrt(dot(normal, normal)), offset = dot(a, normal) / length;

    if (std::fabs(offset) <= q.r) {
      const Vector nearest = methods::ClosestPoint::closest(start, Real(0));
      if (dot(nearest, nearest) <= rr) return false;
    }
    const auto during = [](Real t) { return t >= 0 && t <= 1; };

    const Real radius = offset < 0 ? -q.r : q.r;
    const Real t = (offset - radius) / (dot(q.d, normal) / length);
    if (during(t)) {
      const Vector foot = q.d * t + normal * (radius / length);
      const auto inside = [&](const Vector& from, const Vector& to) {
        return dot(cross(to - from, foot - from), normal) >= 0;
      };
      if (inside(a, b) && inside(b, c) && inside(c, a)) return false;
    }
    return !(meets_edge(q.d, a, b, rr) || meets_edge(q.d, b, c, rr) || meets_edge(q.d, c, a, rr) ||
             meets_vertex(q.d, a, rr) || meets_vertex(q.d, b, rr) || meets_vertex(q.d, c, rr));
  }

 private:
  // The first root of a t^2 - 2 b t + c; NaN where there is none.
  template <class Real>
  static Real first_root(Real a, Real b, Real c) {
    return (b - std::sqrt(b * b - a * c)) / a;
  }
  template <class Real>
  static bool meets_edge(const portable::Vec3<Real>& d, const portable::Vec3<Real>& from,
                         const portable::Vec3<Real>& to, Real rr) {
    const portable::Vec3<Real> along = to - from, n = cross(from, along), m = cross(d, along);
    const Real e = dot(along, along), t = first_root(dot(m, m), dot(n, m), dot(n, n) - rr * e);
    const Real foot = dot(d * t - from, along);
    return t >= 0 && t <= 1 && foot >= 0 && foot <= e;
  }
  template <class Real>
  static bool meets_vertex(const portable::Vec3<Real>& d, const portable::Vec3<Real>& at, Real rr) {
    const Real t = first_root(dot(d, d), dot(at, d), dot(at, at) - rr);
    return t >= 0 && t <= 1;
  }
};

}  // namespace axiscert::moving_sphere
