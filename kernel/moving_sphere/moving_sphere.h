// A query of the moving sphere as the formulae see it: the triangle ABC, and a sphere of radius r whose centre is
// P + t D for t in [0, 1].
#pragma once

#include "kernel/base/geometry.h"
#include "kernel/plain_kernel.h"

namespace axiscert {

const TestDescription& moving_sphere_test();

// A query with names. Its numbers are in the order of the columns.
template <class Real>
struct MovingQuery {
  portable::Vec3<Real> a, b, c, p, d;
  Real r;
  operator Numbers<Real>() const {
    return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, p.x, p.y, p.z, d.x, d.y, d.z, r};
  }
};

struct MovingSphere {
  static const TestDescription& description() { return moving_sphere_test(); }

  template <class T>
  using Problem = MovingQuery<T>;
  template <class T, class Load>
  static Problem<T> problem(Load&& load) {
    const auto vector = [&](std::size_t k) { return portable::Vec3<T>{load(k), load(k + 1), load(k + 2)}; };
    return {vector(0), vector(3), vector(6), vector(9), vector(12), load(15)};
  }
};

}  // namespace axiscert
