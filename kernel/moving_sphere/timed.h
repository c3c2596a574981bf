// Methods that find the first time of contact, and a verdict by it.
#pragma once

#include <optional>

#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/moving_sphere/rounded.h"

namespace axiscert::moving_sphere {

// A method M has first_time(q): the time in [0, 1] at which it finds the first contact, empty where it finds none.
template <class M>
struct Timed : M {
  template <class Real>
  static bool separated(const MovingQuery<Real>& q) {
    return !M::template first_time<Real>(q);
  }
};

// A form without branches as such a method.
template <class Form>
struct OneNumber {
  template <class Real>
  static std::optional<Real> first_time(const MovingQuery<Real>& q) {
    const auto hit = Form::template first<Real>(q);
    return hit.contact ? std::optional(hit.time) : std::nullopt;
  }
};

}  // namespace axiscert::moving_sphere
