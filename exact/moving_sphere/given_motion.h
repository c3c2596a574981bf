// A motion as the exact side takes it, in either entry of the predicate.
#pragma once

#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert::moving_sphere {

// The numbers as they were given. `to` is the displacement D, or the end P1 of the motion, whose displacement P1 - P is
// exact here though no number may be it.
struct GivenMotion {
  portable::Vec3<double> a, b, c, p, to;
  bool to_is_end;
  double r;

  GivenMotion(const MovingQuery<double>& q) : a(q.a), b(q.b), c(q.c), p(q.p), to(q.d), to_is_end(false), r(q.r) {}
  GivenMotion(const EndsQuery<double>& q) : a(q.a), b(q.b), c(q.c), p(q.p), to(q.p1), to_is_end(true), r(q.r) {}

  // D in the exact numbers T that `exactly(x)` makes of a double.
  template <class T, class Exactly>
  portable::Vec3<T> displacement(Exactly&& exactly) const {
    const auto vector = [&](const portable::Vec3<double>& v) {
      return portable::Vec3<T>{exactly(v.x), exactly(v.y), exactly(v.z)};
    };
    if (to_is_end) return vector(to) - vector(p);
    return vector(to);
  }
};

}  // namespace axiscert::moving_sphere
