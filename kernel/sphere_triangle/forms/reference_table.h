// The scalar reference of every set of formulae in one arithmetic.
#pragma once

#include <algorithm>

#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/sphere_triangle/forms/formulae_types.h"

namespace axiscert {

template <class Real>
using ReferenceFunction = Outcome (*)(const Query<Real>&, Strictness, Sides<Real>*);

// Null where the formulae do not exist in the arithmetic.
struct ReferenceTable {
  EnumArray<Formulae, ReferenceFunction<float>> binary32{};
  EnumArray<Formulae, ReferenceFunction<double>> binary64{};
};

// The query translated to the sphere's centre, then scaled by the power of two that brings the greatest number to [1,
// 2). The scaling is exact except for numbers 2^126 times less than the greatest (in binary64 2^1022).
template <class Real>
Query<Real> prescaled(const Query<Real>& q) {
  const Query<Real> moved{q.a - q.p, q.b - q.p, q.c - q.p, {0, 0, 0}, q.r};
  Real greatest = 0;
  for (const Real x : coordinates(moved)) greatest = std::max(greatest, std::fabs(x));
  if (!(greatest > 0) || !std::isfinite(greatest)) return moved;
  const int down = -std::ilogb(greatest);
  auto scaled = coordinates(moved);
  for (Real& x : scaled) x = std::ldexp(x, down);
  return from_coordinates(scaled);
}

// Not inlined, with operands read from memory and results written to memory, so that no operation moves out of the
// floating-point environment that the caller has set.
template <class F, class A, class Real>
[[gnu::noinline]] Outcome reference_outcome(const Query<Real>& q, Strictness strictness, Sides<Real>* sides) {
  using Base = typename A::template BaseOf<Real>;
  using T = typename A::template Number<Base>;
  const auto problem = problem_as<T>(q, [](Real x) { return T(static_cast<Base>(x)); });
  if constexpr (requires { F::separated(problem); }) {
    return outcome_of<F>(problem, strictness);
  } else {
    Sides<T> found;
    const Outcome outcome = outcome_of<F>(problem, strictness, &found);
    if (sides) {
      const auto rounded = [](const T& x) { return static_cast<Real>(static_cast<Base>(x)); };
      std::transform(found.lhs.begin(), found.lhs.end(), sides->lhs.begin(), rounded);
      std::transform(found.rhs.begin(), found.rhs.end(), sides->rhs.begin(), rounded);
    }
    return outcome;
  }
}

template <class F, class A, class Real>
Outcome reference_in_environment(const Query<Real>& q, Strictness strictness, Sides<Real>* sides) {
  if constexpr (A::prescaled) {
    return reference_outcome<F, A>(prescaled(q), strictness, sides);
  } else if constexpr (A::rounding != Rounding::nearest || A::flush) {
    const FloatingEnvironment environment(A::rounding, A::flush);
    return reference_outcome<F, A>(q, strictness, sides);
  } else {
    return reference_outcome<F, A>(q, strictness, sides);
  }
}

template <Arithmetic arithmetic>
constexpr ReferenceTable reference_table() {
  using A = ArithmeticType<arithmetic>;
  ReferenceTable table;
  const auto fill = [&]<std::size_t i>() {
    constexpr auto formulae = static_cast<Formulae>(i);
    using F = FormulaeType<formulae>;
    if constexpr (arithmetic == Arithmetic::plain || kind_of(formulae) == FormulaeKind::rung) {
      if constexpr (A::in_binary32) table.binary32[i] = reference_in_environment<F, A, float>;
      if constexpr (A::in_binary64) table.binary64[i] = reference_in_environment<F, A, double>;
    }
  };
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (fill.template operator()<i>(), ...);
  }(std::make_index_sequence<formulae_count>());
  return table;
}

}  // namespace axiscert
