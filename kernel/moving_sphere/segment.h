// The least distance of the centre's path, a segment, from the triangle, and one comparison with r r. It has a verdict
// and no time.
#pragma once

#include <algorithm>

#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/sphere_triangle/forms/methods.h"

namespace axiscert::moving_sphere {

// A segment is nearest to a triangle at one of its own ends, on an edge of the triangle, or where it crosses the face.
// Over the reals it is right for every query in which no two vertices are equal. Rounding decides between parallel
// segments and others by the sign of a difference that cancels; and of a path in the plane of the face, whether it
// crosses it by three such signs: contacts are invented there at any distance.
// Source: C. Ericson, Real-Time Collision Detection (2005), sections 5.1.9 (two segments), 5.1.5 and 5.3.4, with 0 for
// its thresholds.
struct Segment {
  template <class Real>
  constexpr static bool separated(const MovingQuery<Real>& q) {
    using portable::dot;
    const portable::CentredProblem<Real> start{q.a - q.p, q.b - q.p, q.c - q.p, q.r * q.r};
    const auto& [a, b, c, rr] = start;
    const portable::CentredProblem<Real> end{a - q.d, b - q.d, c - q.d, rr};
    for (const portable::CentredProblem<Real>& still : {start, end}) {
      const portable::Vec3<Real> nearest = methods::ClosestPoint::closest(still, Real(0));
      if (dot(nearest, nearest) <= rr) return false;
    }
    return squared_distance(q.d, a, b) > rr && squared_distance(q.d, b, c) > rr && squared_distance(q.d, c, a) > rr &&
           !crosses(q.d, a, b, c);
  }

  // The shares `s` of the path 0 to `d` and `t` of the segment `from` to `to` at which they are nearest.
  template <class Real>
  struct Shares {
    Real s = 0, t = 0;
  };
  template <class Real>
  constexpr static Shares<Real> nearest_shares(const portable::Vec3<Real>& d, const portable::Vec3<Real>& from,
                                               const portable::Vec3<Real>& to) {
    using portable::dot;
    const auto in_unit = [](Real x) { return std::clamp(x, Real(0), Real(1)); };
    const portable::Vec3<Real> along = to - from;
    const Real dd = dot(d, d), e = dot(along, along), both = dot(d, along);
    const Real ahead = dot(d, from), behind = -dot(along, from);
    Real s = 0, t = 0;
    if (dd > 0 && e > 0) {
      const Real not_parallel = dd * e - both * both;
      if (not_parallel != 0) s = in_unit((both * behind + ahead * e) / not_parallel);
      t = (both * s + behind) / e;
      if (t < 0) s = in_unit(ahead / dd);
      if (t > 1) s = in_unit((both + ahead) / dd);
      t = in_unit(t);
    } else if (e > 0) {
      t = in_unit(behind / e);
    } else if (dd > 0) {
      s = in_unit(ahead / dd);
    }
    return {s, t};
  }

  template <class Real>
  constexpr static bool crosses(const portable::Vec3<Real>& d, const portable::Vec3<Real>& a,
                                const portable::Vec3<Real>& b, const portable::Vec3<Real>& c) {
    using portable::cross;
    using portable::dot;
    const portable::Vec3<Real> normal = cross(b - a, c - a);
    const Real before = dot(a, normal), after = dot(a - d, normal);
    if ((before > 0 && after > 0) || (before < 0 && after < 0)) return false;
    const Real u = dot(d, cross(b, c)), v = dot(d, cross(c, a)), w = dot(d, cross(a, b));
    return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
  }

 private:
  template <class Real>
  constexpr static Real squared_distance(const portable::Vec3<Real>& d, const portable::Vec3<Real>& from,
                                         const portable::Vec3<Real>& to) {
    const auto [s, t] = nearest_shares(d, from, to);
    const portable::Vec3<Real> between = from + (to - from) * t - d * s;
    return portable::dot(between, between);
  }
};

}  // namespace axiscert::moving_sphere
