// Queries of the moving sphere as the formulae see them: the triangle ABC, and a sphere of radius r whose centre is
// P + t D for t in [0, 1]. The motion is given by D, or by its end P1 = P + D.
#pragma once

#include "kernel/base/geometry.h"
#include "kernel/formulae_kernel.h"

namespace axiscert {

const Predicate& moving_sphere_predicate();

namespace moving_sphere {
// Adds the comparisons and clauses of the twenty axes, which a capsule's description has too.
void add_twenty_axes(Predicate& predicate);
}  // namespace moving_sphere

// A query with names. Its numbers are in the order of the columns.
template <class Real>
struct MovingQuery {
  portable::Vec3<Real> a, b, c, p, d;
  Real r;
  operator Numbers<Real>() const {
    return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, p.x, p.y, p.z, d.x, d.y, d.z, r};
  }
};

// The same by both ends of the motion. Its displacement P1 - P need not be a number of the precision.
template <class Real>
struct EndsQuery {
  portable::Vec3<Real> a, b, c, p, p1;
  Real r;
  operator Numbers<Real>() const {
    return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, p.x, p.y, p.z, p1.x, p1.y, p1.z, r};
  }
};

// The predicate in its entry `displacement`.
struct MovingSphere {
  static constexpr std::size_t entry = 0;
  static const Predicate& description() { return moving_sphere_predicate(); }

  template <class T>
  using Problem = MovingQuery<T>;
  template <class T, class Load>
  constexpr static Problem<T> problem(Load&& load) {
    const auto vector = [&](std::size_t k) { return portable::Vec3<T>{load(k), load(k + 1), load(k + 2)}; };
    return {vector(0), vector(3), vector(6), vector(9), vector(12), load(15)};
  }
};

// The predicate in its entry `endpoints`.
struct MovingEnds {
  static constexpr std::size_t entry = 1;
  static const Predicate& description() { return moving_sphere_predicate(); }

  template <class T>
  using Problem = EndsQuery<T>;
  template <class T, class Load>
  constexpr static Problem<T> problem(Load&& load) {
    const auto vector = [&](std::size_t k) { return portable::Vec3<T>{load(k), load(k + 1), load(k + 2)}; };
    return {vector(0), vector(3), vector(6), vector(9), vector(12), load(15)};
  }
};

}  // namespace axiscert
