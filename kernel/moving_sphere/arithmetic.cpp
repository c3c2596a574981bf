#include "kernel/moving_sphere/kernels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/moving_sphere/twenty.h"

namespace axiscert::moving_sphere {
namespace {

// Both relations of each comparison, and the sides rounded to the query's precision where they are asked for.
template <class Real>
struct TwentySides {
  ComparisonBits greater = 0, not_less = 0;
  Answers<Real>* out = nullptr;
  std::size_t at = 0;  // query of `out`
};

template <class Base, class Real>
struct TwentySink {
  TwentySides<Real>& found;
  template <class T>
  void operator()(std::size_t i, const T& lhs, const T& rhs) {
    found.greater |= bit_if<ComparisonBits>(lhs > rhs, i);
    found.not_less |= bit_if<ComparisonBits>(lhs >= rhs, i);
    if (!found.out) return;
    found.out->lhs[i][found.at] = static_cast<Real>(static_cast<Base>(lhs));
    found.out->rhs[i][found.at] = static_cast<Real>(static_cast<Base>(rhs));
  }
};

// Not inlined, with operands read from memory and results written to memory, so that no operation moves out of the
// floating-point environment that the caller has set.
template <class A, class Real>
[[gnu::noinline]] void evaluate_twenty(const Numbers<Real>& q, TwentySides<Real>& found) {
  using Base = typename A::template BaseOf<Real>;
  using T = typename A::template Number<Base>;
  TwentySink<Base, Real> sink{found};
  Twenty::comparisons<T>(MovingSphere::problem<T>([&](std::size_t k) { return T(static_cast<Base>(q[k])); }), sink);
}

// Moved to the sphere's centre, then scaled by the power of two that brings the greatest number to [1, 2).
template <class Real>
Numbers<Real> prescaled_motion(Numbers<Real> q) {
  for (std::size_t k = 0; k < 9; ++k) q[k] -= q[9 + k % 3];
  for (std::size_t k = 9; k < 12; ++k) q[k] = 0;
  Real greatest = 0;
  for (const Real x : q) greatest = std::max(greatest, std::fabs(x));
  if (!(greatest > 0) || !std::isfinite(greatest)) return q;
  const int down = -std::ilogb(greatest);
  for (Real& x : q) x = std::ldexp(x, down);
  return q;
}

template <class A, class Real>
void twenty_in_environment(const Numbers<Real>& q, TwentySides<Real>& found) {
  if constexpr (A::prescaled) {
    evaluate_twenty<A>(prescaled_motion(q), found);
  } else if constexpr (A::rounding != Rounding::nearest || A::flush) {
    const FloatingEnvironment environment(A::rounding, A::flush);
    evaluate_twenty<A>(q, found);
  } else {
    evaluate_twenty<A>(q, found);
  }
}

template <class A, class Real>
Implementation<Real> twenty_implementation(ComparisonBits nonstrict) {
  const auto bits_at = [=](const QueryColumns<Real>& batch, std::size_t i, Answers<Real>* out) {
    Numbers<Real> q(batch.count);
    for (std::size_t k = 0; k < batch.count; ++k) q[k] = batch.column[k][i];
    TwentySides<Real> found{.out = out, .at = i};
    twenty_in_environment<A>(q, found);
    return (found.greater & ~nonstrict) | (found.not_less & nonstrict);
  };
  Implementation<Real> made;
  made.verdicts = [=](const QueryColumns<Real>& batch, Verdict* out) {
    for (std::size_t i = 0; i < batch.size; ++i)
      out[i] = verdict_of(moving_sphere_predicate(), bits_at(batch, i, nullptr));
  };
  made.explain = [=](const QueryColumns<Real>& batch, Answers<Real>& out) {
    for (std::size_t i = 0; i < batch.size; ++i) out.bits[i] = bits_at(batch, i, &out);
  };
  return made;
}

template <class A>
void put_twenty(ComparisonBits nonstrict, Kernel& kernel) {
  if constexpr (A::in_binary32)
    kernel.binary32 = [=](std::string_view) { return twenty_implementation<A, float>(nonstrict); };
  if constexpr (A::in_binary64)
    kernel.binary64 = [=](std::string_view) { return twenty_implementation<A, double>(nonstrict); };
}

}  // namespace

Kernel twenty_in(std::string_view id, const Kernel& rung, const ArithmeticInfo& arithmetic) {
  Kernel kernel;
  kernel.id = id;
  kernel.summary = fmt::format("{}; {}", rung.summary, arithmetic.summary);
  kernel.predicate = rung.predicate;
  kernel.formulae = rung.formulae;
  kernel.arithmetic = arithmetic.arithmetic;
  kernel.exposes = arithmetic.exposes;
  kernel.is_reference = false;
  const ComparisonBits nonstrict = rung.formulae == TwentyNonstrict::name ? side_bits : 0;
  switch (arithmetic.arithmetic) {
#define AXISCERT_CASE(name, type, summary)                     \
  case Arithmetic::name:                                       \
    put_twenty<axiscert::arithmetic::type>(nonstrict, kernel); \
    break;
    AXISCERT_ARITHMETICS(AXISCERT_CASE)
#undef AXISCERT_CASE
  }
  return kernel;
}

}  // namespace axiscert::moving_sphere
