// For the tests of the moving sphere: queries by hand and at random, and oracles with a planted fault.
#pragma once

#include <random>

#include "exact/moving_sphere/trait.h"
#include "exact/trait/oracles_of.h"

namespace axiscert::moving_sphere {

// The motion from (0, 0, 3) by `d` past the triangle (0,0,0) (4,0,0) (0,4,0).
inline MovingQuery<double> at_the_corner(const portable::Vec3<double>& p, const portable::Vec3<double>& d, double r) {
  return {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p, d, r};
}

// Small integers, degenerate queries among them.
inline MovingQuery<double> small_query(std::mt19937_64& random, int bound) {
  const auto whole = [&] {
    return static_cast<double>(static_cast<int>(random() % static_cast<unsigned>(2 * bound + 1)) - bound);
  };
  const auto point = [&] {
    const double x = whole(), y = whole(), z = whole();
    return portable::Vec3<double>{x, y, z};
  };
  MovingQuery<double> q;
  for (portable::Vec3<double>* v : {&q.a, &q.b, &q.c, &q.p, &q.d}) *v = point();
  q.r = static_cast<double>(random() % static_cast<unsigned>(4 * bound + 1)) / 2;
  return q;
}

// Faults of the twenty axes: one comparison with its sides exchanged, or one axis that never separates.
struct PlantedAxes : Twenty {
  inline static std::size_t exchanged = comparison_names.size();  // none
  inline static std::string_view dropped = "";
  template <class T, class Sink>
  static void comparisons(const MovingSphere::Problem<T>& q, Sink& sink) {
    const T zero(0.0);
    const auto planted = [&](std::size_t i, const T& lhs, const T& rhs) {
      if (clause_name(i) == dropped && is_radius(i)) sink(i, zero, zero);
      else if (i == exchanged) sink(i, rhs, lhs);
      else sink(i, lhs, rhs);
    };
    Twenty::comparisons<T>(q, planted);
  }
};
struct WithPlantedAxes : MovingSphereTrait {
  using AllFormulae = FormulaeList<PlantedAxes>;
};

// A bound that should be closed: touching is no contact.
struct WithOpenBound : MovingSphereTrait {
  static Truth geometric_truth(const Numbers<double>& numbers) {
    const Truth right = MovingSphereTrait::geometric_truth(numbers);
    return right.touching ? Truth{Verdict::separated, false} : right;
  }
};

}  // namespace axiscert::moving_sphere
