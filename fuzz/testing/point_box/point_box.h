// The toy of the test suite: a point against a closed box along the axes. It is what a second predicate has to supply,
// at its least.
#pragma once

#include "kernel/base/geometry.h"
#include "kernel/formulae_kernel.h"

namespace axiscert {

const Predicate& point_box_predicate();

struct PointBox {
  static const Predicate& description() { return point_box_predicate(); }

  // The box is from corner `low` to corner `high`.
  template <class T>
  struct Problem {
    portable::Vec3<T> p, low, high;
  };
  template <class T, class Load>
  static Problem<T> problem(Load&& load) {
    const auto corner = [&](std::size_t k) { return portable::Vec3<T>{load(k), load(k + 1), load(k + 2)}; };
    return {corner(0), corner(3), corner(6)};
  }
};

// The point lies beyond one of the six faces. Degree 1; nothing is rounded.
struct PointBoxFaces {
  static constexpr std::string_view name = "faces";
  static constexpr FormulaeKind kind = FormulaeKind::rung;
  template <class T, class Sink>
  static void comparisons(const PointBox::Problem<T>& q, Sink& sink) {
    sink(0, q.low.x, q.p.x);
    sink(1, q.p.x, q.high.x);
    sink(2, q.low.y, q.p.y);
    sink(3, q.p.y, q.high.y);
    sink(4, q.low.z, q.p.z);
    sink(5, q.p.z, q.high.z);
  }
};

}  // namespace axiscert
