// The seven axes of the static predicate, tracked over time: what the article calls messy.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "kernel/moving_sphere/timed.h"
#include "kernel/moving_sphere/twenty.h"

namespace axiscert::moving_sphere {

// The times at which one axis separates: where its radius margin a t^2 - 2 b t + c is positive, at most before one root
// and after the other, and none of its sides, linear in t, is negative.
template <class Real>
class AxisTimes {
 public:
  // The margin with its discriminant b^2 - a c as a difference of products; if a is 0, so is b.
  AxisTimes(Real a, Real b, Real c, Real discriminant) {
    if (!(a > 0)) {
      if (c > 0) before_ = infinity;
    } else if (discriminant < 0) {
      before_ = infinity;
    } else {
      const Real root = std::sqrt(discriminant);  // each root is the quotient in which nothing cancels
      before_ = b > 0 ? c / (b + root) : (b - root) / a;
      after_ = b > 0 ? (b + root) / a : c / (b - root);
    }
  }
  // And the side value + slope t has to be not negative.
  void require(Real value, Real slope) {
    const Real end = -value / slope;
    if (slope > 0) first_ = std::max(first_, end);
    else if (slope < 0) last_ = std::min(last_, end);
    else if (!(value >= 0)) first_ = infinity;
  }

  // How far an interval that holds t goes; less than t where none holds it.
  Real end_from(Real t) const {
    if (!(first_ <= t && t <= last_)) return -infinity;
    if (t < before_) return std::min(before_, last_);
    return t > after_ ? last_ : -infinity;
  }

 private:
  static constexpr Real infinity = std::numeric_limits<Real>::infinity();
  Real before_ = -infinity, after_ = infinity;  // the margin is positive before the one and after the other
  Real first_ = -infinity, last_ = infinity;
};

// From t = 0 to the farthest end of an interval that holds t, and so on: where none goes on is the first contact, and
// past 1 there is none. An axis separates on at most two intervals, so there are at most fourteen steps. Over the reals
// it is right for every query. Which of two axes' ends is later is a comparison of their roots, of degree up to 28;
// here each is rounded, so that neighbours may leave a gap of an ulp, a phantom or an early hit, or overlap by one. The
// plane's b^2 - a c is of degree 12. Source: C. Ericson, Optimizing a sphere-triangle intersection test (2010), the
// closing question.
struct Walk {
  static constexpr int most_steps = 14;

  template <class Real>
  static std::optional<Real> first_time(const MovingQuery<Real>& q) {
    const std::array<AxisTimes<Real>, 7> axes = axes_of(q);
    Real t = 0;
    for (int step = 0; step < most_steps; ++step) {
      Real end = t;
      for (const AxisTimes<Real>& axis : axes) end = std::max(end, axis.end_from(t));
      if (end > 1) return std::nullopt;
      if (!(end > t)) return t == 1 && is_separated_at(axes, t) ? std::nullopt : std::optional(t);
      t = end;
    }
    return t;
  }

 private:
  // An interval may end at 1 and still hold it.
  template <class Real>
  static bool is_separated_at(const std::array<AxisTimes<Real>, 7>& axes, Real t) {
    return std::any_of(axes.begin(), axes.end(), [&](const AxisTimes<Real>& axis) { return axis.end_from(t) >= t; });
  }

  template <class Real>
  static std::array<AxisTimes<Real>, 7> axes_of(const MovingQuery<Real>& q) {
    const Vec3<Real> a = q.a - q.p, b = q.b - q.p, c = q.c - q.p, d = q.d;
    const Vec3<Real> normal = cross(b - a, c - a);
    const Real rr = q.r * q.r, offset = dot(a, normal), m = dot(d, normal), area = rr * dot(normal, normal);
    const auto vertex = [&](const Vec3<Real>& at, const Vec3<Real>& one, const Vec3<Real>& other) {
      const Vec3<Real> w = cross(at, d);
      const Real dd = dot(d, d);
      AxisTimes<Real> times(dd, dot(at, d), dot(at, at) - rr, rr * dd - dot(w, w));
      for (const Vec3<Real>& along : {one - at, other - at}) times.require(dot(at, along), -dot(d, along));
      return times;
    };
    const auto edge = [&](const Vec3<Real>& from, const Vec3<Real>& to) {
      const Vec3<Real> along = to - from, n = cross(from, along), across = cross(d, along);
      const Real e = dot(along, along), aa = dot(across, across), delta = dot(from, across);
      AxisTimes<Real> times(aa, dot(n, across), dot(n, n) - rr * e, e * (rr * aa - delta * delta));
      times.require(-dot(n, normal), dot(across, normal));
      return times;
    };
    return {AxisTimes<Real>(m * m, offset * m, offset * offset - area, (m * m) * area),
            vertex(a, b, c),
            vertex(b, a, c),
            vertex(c, a, b),
            edge(a, b),
            edge(b, c),
            edge(c, a)};
  }
};

}  // namespace axiscert::moving_sphere
