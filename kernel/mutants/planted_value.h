// The fault of a value at work, on the queries of a few lanes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/base/geometry.h"
#include "kernel/mutants/mutant.h"

namespace axiscert::mutants {

template <class Real>
class PlantedValue {
 public:
  using Values = Lanes<Real>;
  static constexpr std::size_t width = Values::width;
  std::array<bool, width> is_early{};

  // `number` gives the numbers of a query in the order of the columns, lane by lane: number(lane, k).
  template <class Numbers>
  PlantedValue(const Mutant& mutant, const Numbers& number) : mutant_(mutant) {
    for (std::size_t i = 0; i < width; ++i) {
      const auto from = [&](std::size_t first, std::size_t origin) {
        return portable::Vec3<Real>{number(i, first) - number(i, origin), number(i, first + 1) - number(i, origin + 1),
                                    number(i, first + 2) - number(i, origin + 2)};
      };
      const auto square = [](const portable::Vec3<Real>& u) { return u.x * u.x + u.y * u.y + u.z * u.z; };
      e_.at[i] = magnitude();
      if (mutant.is_relative) e_.at[i] *= scale(square(from(0, 9)), square(from(3, 0)), square(from(6, 0)));
      if (mutant.quantity == Quantity::verdict && answers_early(mutant.value)) {
        Real extent = 0;
        for (std::size_t k = 0; k < 9; ++k) extent = std::max(extent, std::fabs(number(i, k) - number(i, 9 + k % 3)));
        is_early[i] = extent < e_.at[i];
      }
    }
  }

  // A radius, or a result of an operation.
  Values replaced(const Values& x) {
    return Values::of([&](std::size_t i) {
      const bool is_of_itself = mutant_.is_relative && adds(mutant_.value);
      const Real e = is_of_itself ? magnitude() * std::fabs(x.at[i]) : e_.at[i];
      is_early[i] |= answers_early(mutant_.value) && std::fabs(x.at[i]) < e;
      return faulty(mutant_.value, x.at[i], e);
    });
  }

  // The left side of this comparison in lane i.
  Real left(std::size_t which, std::size_t i, Real lhs, Real rhs) {
    const bool is_here =
        mutant_.quantity == Quantity::verdict || (mutant_.quantity == Quantity::side && which == mutant_.place);
    if (!is_here) return lhs;
    const Real e = mutant_.is_relative ? magnitude() * (std::fabs(lhs) + std::fabs(rhs)) : magnitude();
    if (mutant_.quantity == Quantity::side && answers_early(mutant_.value))
      is_early[i] |= std::fabs(mutant_.is_relative ? lhs - rhs : lhs) < e;
    return faulty(mutant_.value, lhs, e);
  }

 private:
  Real magnitude() const { return static_cast<Real>(mutant_.magnitude); }
  Real scale(Real aa, Real ab, Real ac) const {
    switch (mutant_.quantity) {
      case Quantity::radius:
        return std::sqrt(aa);
      case Quantity::squared_radius:
      case Quantity::squared_edge:
        return aa;
      case Quantity::squared_normal:
        return ab * ac;
      case Quantity::side:
      case Quantity::verdict:
        break;
    }
    return 1;
  }

  const Mutant& mutant_;
  Values e_;
};

}  // namespace axiscert::mutants
