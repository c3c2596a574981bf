// The sweep of "Improved Collision detection and Response", from which most hobby engines begin.
#pragma once

#include <cmath>
#include <utility>

#include "kernel/moving_sphere/timed.h"

namespace axiscert::moving_sphere {

// All lengths over r, so that the sphere is the unit sphere. The time at which it touches the plane, if the touching
// point is in the triangle; else the least root in (0, 1) of the three vertices and the three edges.
//
// The method is one-sided: it leaves out a triangle that faces away. Here the triangle is turned to face the motion, as
// for a mesh of two sides, so that this is no fault. What remains wrong over the reals: it has no predicate of the
// start, so an overlap that a vertex or an edge makes is met at its end, late, or missed; r = 0 divides by 0; D = 0 has
// no roots; zero area has no normal; roots at 0 and at 1 are no contact. Degrees: roots of degree 8 after a division by
// r. Source: K. Fauerby, Improved Collision detection and Response (2003), appendix.
struct Fauerby {
  template <class Real>
  static std::optional<Real> first_time(const MovingQuery<Real>& q) {
    using Vector = portable::Vec3<Real>;
    const Vector velocity = q.d / q.r;
    Triangle<Real> triangle{(q.a - q.p) / q.r, (q.b - q.p) / q.r, (q.c - q.p) / q.r, {}};
    triangle.normal = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    if (dot(triangle.normal, velocity) > 0) {
      std::swap(triangle.b, triangle.c);
      triangle.normal = triangle.normal * Real(-1);
    }
    triangle.normal = triangle.normal / std::sqrt(dot(triangle.normal, triangle.normal));

    const Real distance = -dot(triangle.a, triangle.normal), closing = dot(triangle.normal, velocity);
    if (closing == 0) {
      if (std::fabs(distance) >= 1) return std::nullopt;
    } else {
      Real begin = (-1 - distance) / closing, end = (1 - distance) / closing;
      if (begin > end) std::swap(begin, end);
      if (begin > 1 || end < 0) return std::nullopt;
      begin = begin < 0 ? Real(0) : begin;
      if (is_inside(triangle, velocity * begin - triangle.normal)) return begin;
    }

    Real first = 1;
    bool found = false;
    const auto take = [&](Real t) {
      first = t;
      found = true;
    };
    for (const Vector& at : {triangle.a, triangle.b, triangle.c}) {
      if (const auto t = root(dot(velocity, velocity), -2 * dot(velocity, at), dot(at, at) - 1, first)) take(*t);
    }
    for (const auto& [from, to] :
         {std::pair{triangle.a, triangle.b}, std::pair{triangle.b, triangle.c}, std::pair{triangle.c, triangle.a}}) {
      const Vector along = to - from;
      const Real e = dot(along, along), ahead = dot(along, velocity), behind = dot(along, from);
      const auto t =
          root(ahead * ahead - e * dot(velocity, velocity), e * (2 * dot(velocity, from)) - 2 * ahead * behind,
               e * (1 - dot(from, from)) + behind * behind, first);
      if (!t) continue;
      const Real share = (ahead * *t - behind) / e;
      if (share >= 0 && share <= 1) take(*t);
    }
    return found ? std::optional(first) : std::nullopt;
  }

 private:
  template <class Real>
  struct Triangle {
    portable::Vec3<Real> a, b, c, normal;
  };

  // Weights by dot products, none negative and their sum less than 1.
  template <class Real>
  static bool is_inside(const Triangle<Real>& triangle, const portable::Vec3<Real>& point) {
    const auto one = triangle.b - triangle.a, other = triangle.c - triangle.a, to = point - triangle.a;
    const Real oo = dot(one, one), ot = dot(one, other), tt = dot(other, other);
    const Real all = oo * tt - ot * ot, along_one = dot(to, one), along_other = dot(to, other);
    const Real x = along_one * tt - along_other * ot, y = along_other * oo - along_one * ot;
    return x + y - all < 0 && x >= 0 && y >= 0;
  }

  // The least root of a t^2 + b t + c in (0, limit).
  template <class Real>
  static std::optional<Real> root(Real a, Real b, Real c, Real limit) {
    const Real discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return std::nullopt;
    const Real width = std::sqrt(discriminant);
    Real one = (-b - width) / (2 * a), other = (-b + width) / (2 * a);
    if (one > other) std::swap(one, other);
    if (one > 0 && one < limit) return one;
    if (other > 0 && other < limit) return other;
    return std::nullopt;
  }
};

}  // namespace axiscert::moving_sphere
