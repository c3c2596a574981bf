// A query of a capsule and a triangle as the formulae see it: ABC, and the points no farther than r from the segment P
// to Q. It is where a sphere of radius r was that moved from P to Q, so the formulae of a moving sphere by its ends are
// its own too (kernel/moving_sphere).
#pragma once

#include "kernel/formulae_kernel.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert {

const Predicate& capsule_triangle_predicate();

struct Capsule {
  static const Predicate& description() { return capsule_triangle_predicate(); }

  // p1 is Q.
  template <class T>
  using Problem = EndsQuery<T>;
  template <class T, class Load>
  static Problem<T> problem(Load&& load) {
    return MovingEnds::problem<T>(load);
  }
};

}  // namespace axiscert
