// Methods that find the first contact: a verdict by it, and the measures of it that they give.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/moving_sphere/names.h"
#include "kernel/moving_sphere/rounded.h"

namespace axiscert::moving_sphere {

// A contact as the measures have it; points and vectors are seen from P.
template <class Real>
struct ContactFound {
  static constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
  Real time = none;
  Real feature = none;
  portable::Vec3<Real> point{none, none, none};
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

// A method M has first_time(q): the time in [0, 1] at which it finds the first contact, empty where it finds none. If
// it finds more of it, M has first_contact(q) too.
template <class M>
struct TimedMethod : M {
  template <class Real>
  static constexpr bool finds_all = requires(const MovingQuery<Real>& q) { M::first_contact(q); };
  static constexpr std::size_t measure_count = finds_all<float> ? moving_sphere::measure_count : 1;

  template <class Real>
  static bool separated(const MovingQuery<Real>& q) {
    return !M::template first_time<Real>(q);
  }
  template <class Real>
  static void measure(const MovingQuery<Real>& q, Real* out) {
    if constexpr (finds_all<Real>) put_measures(q, M::first_contact(q).value_or(ContactFound<Real>{}), out);
    else out[time_measure] = M::template first_time<Real>(q).value_or(ContactFound<Real>::none);
  }
};

// A hit of the pieces of `rounded`, with the triangle's point.
template <class Real>
ContactFound<Real> contact_of(const portable::Start<Real>& q, const portable::FirstHit<Real>& hit) {
  const std::array<portable::Vec3<Real>, 3> corners = {q.a, q.b, q.c};
  if (hit.feature < 0) return {hit.time, ContactFound<Real>::none, portable::nearest_point(q.a, q.b, q.c)};
  const auto which = static_cast<std::size_t>(hit.feature);
  ContactFound<Real> found{hit.time, hit.feature, corners[which % 3]};
  const portable::Vec3<Real> centre = q.d * hit.time;
  if (which == 6) {
    const portable::FacePlane<Real> plane = portable::face_plane(q);
    const Real radius = plane.offset < 0 ? -q.r : q.r;
    found.point = centre + plane.normal * (radius / plane.length);
  } else if (which >= 3) {
    const portable::Vec3<Real> from = corners[which - 3], along = corners[(which - 2) % 3] - from;
    found.point = from + along * (dot(centre - from, along) / dot(along, along));
  }
  return found;
}

// A form without branches as such a method.
template <class Form>
struct OneNumber {
  template <class Real>
  static std::optional<Real> first_time(const MovingQuery<Real>& q) {
    const auto hit = Form::template first<Real>(q);
    return hit.contact ? std::optional(hit.time) : std::nullopt;
  }
  template <class Real>
  static std::optional<ContactFound<Real>> first_contact(const MovingQuery<Real>& q) {
    const auto hit = Form::template first<Real>(q);
    if (!hit.contact) return std::nullopt;
    return contact_of(portable::start_of<Real>(q), hit);
  }
};

}  // namespace axiscert::moving_sphere
