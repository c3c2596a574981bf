// The moving centre as a segment against the triangle rounded by r, piece by piece: the form that engines use. It has a
// verdict, the first contact, and no comparisons.
#pragma once

#include <cmath>
#include <limits>

#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/moving_sphere/names.h"
#include "kernel/sphere_triangle/methods/closest_point.h"

namespace axiscert::moving_sphere {

// A contact as the measures have it; points and vectors are seen from P.
template <class Real>
struct ContactFound {
  static constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
  Real time = none;
  Real feature = none;
  portable::Vec3<Real> point{none, none, none};
  bool is_found() const { return !std::isnan(time); }
};

// Writes the measures of a contact: time, feature, the unit vector from the point to the centre, and the point.
template <class Real>
void put_measures(const MovingQuery<Real>& q, const ContactFound<Real>& contact, Real* out) {
  const portable::Vec3<Real> from = q.d * contact.time - contact.point;
  const portable::Vec3<Real> normal = from * (Real(1) / std::sqrt(portable::dot(from, from)));
  const portable::Vec3<Real> point = contact.point + q.p;
  out[time_measure] = contact.time;
  out[feature_measure] = contact.feature;
  for (const auto& [first, v] : {std::pair{normal_measure, normal}, std::pair{point_measure, point}}) {
    out[first] = v.x;
    out[first + 1] = v.y;
    out[first + 2] = v.z;
  }
}

// Contact where the start overlaps, or the centre meets, at a time in [0, 1], the face moved out by r, the inside of an
// edge's cylinder or a vertex's sphere, the first of these. A time is (b - sqrt(b^2 - a c)) / a, in which both
// differences cancel; over the reals it is right for every triangle with area and D != 0. Where the start overlaps, the
// time is 0 and the feature is not given.
// Source: the method of C. Ericson, Real-Time Collision Detection (2005), section 5.3; closest point 5.1.5.
struct Rounded {
  static constexpr std::size_t measure_count = moving_sphere::measure_count;

  template <class Real>
  static bool separated(const MovingQuery<Real>& q) {
    return !first_contact(q).is_found();
  }
  template <class Real>
  static void measure(const MovingQuery<Real>& q, Real* out) {
    put_measures(q, first_contact(q), out);
  }

 private:
  template <class Real>
  static ContactFound<Real> first_contact(const MovingQuery<Real>& q) {
    using portable::cross;
    using portable::dot;
    using Vector = portable::Vec3<Real>;
    const portable::Centred<Real> start{q.a - q.p, q.b - q.p, q.c - q.p, q.r * q.r};
    const auto& [a, b, c, rr] = start;
    const Vector normal = cross(b - a, c - a);
    const Real length = std::sqrt(dot(normal, normal)), offset = dot(a, normal) / length;

    if (std::fabs(offset) <= q.r) {
      const Vector nearest = methods::ClosestPoint::closest(start, Real(0));
      if (dot(nearest, nearest) <= rr) return {Real(0), ContactFound<Real>::none, nearest};
    }

    const Real radius = offset < 0 ? -q.r : q.r;
    const Real t = (offset - radius) / (dot(q.d, normal) / length);
    if (during(t)) {
      const Vector foot = q.d * t + normal * (radius / length);
      const auto inside = [&](const Vector& from, const Vector& to) {
        return dot(cross(to - from, foot - from), normal) >= 0;
      };
      if (inside(a, b) && inside(b, c) && inside(c, a)) return {t, Real(6), foot};
    }
    ContactFound<Real> first;
    meet_edge(q.d, a, b, rr, 3, first);
    meet_edge(q.d, b, c, rr, 4, first);
    meet_edge(q.d, c, a, rr, 5, first);
    meet_vertex(q.d, a, rr, 0, first);
    meet_vertex(q.d, b, rr, 1, first);
    meet_vertex(q.d, c, rr, 2, first);
    return first;
  }

  template <class Real>
  static bool during(Real t) {
    return t >= 0 && t <= 1;
  }
  // The first root of a t^2 - 2 b t + c; NaN where there is none.
  template <class Real>
  static Real first_root(Real a, Real b, Real c) {
    return (b - std::sqrt(b * b - a * c)) / a;
  }
  // Each of these makes its own contact the first, where it has one and the first so far is not earlier.
  template <class Real>
  static void meet_edge(const portable::Vec3<Real>& d, const portable::Vec3<Real>& from, const portable::Vec3<Real>& to,
                        Real rr, int feature, ContactFound<Real>& first) {
    const portable::Vec3<Real> along = to - from, n = cross(from, along), m = cross(d, along);
    const Real e = dot(along, along), t = first_root(dot(m, m), dot(n, m), dot(n, n) - rr * e);
    const Real foot = dot(d * t - from, along);
    if (!during(t) || !(foot >= 0 && foot <= e) || first.time <= t) return;
    first = {t, static_cast<Real>(feature), from + along * (foot / e)};
  }
  template <class Real>
  static void meet_vertex(const portable::Vec3<Real>& d, const portable::Vec3<Real>& at, Real rr, int feature,
                          ContactFound<Real>& first) {
    const Real t = first_root(dot(d, d), dot(at, d), dot(at, at) - rr);
    if (!during(t) || first.time <= t) return;
    first = {t, static_cast<Real>(feature), at};
  }
};

}  // namespace axiscert::moving_sphere
