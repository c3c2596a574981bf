// Conditions of comparisons against values computed by hand, finite differences, and MPFR at a precision that rounds
// nothing.
#include "exact/sphere_triangle/measures/condition_number.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <random>

#include "kernel/sphere_triangle/forms/evaluate.h"
#include "exact/sphere_triangle/measures/dual.h"
#include "exact/numbers/floating.h"
#include "exact/numbers/mpfr_number.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/forms/formulae_types.h"

namespace axiscert {
namespace {

using Kind = Condition::Kind;

template <class Real>
Condition condition(Formulae formulae, const Query<Real>& q, Comparison which) {
  return conditions(formulae, q, one_bit<ComparisonBits>(which))[which];
}

// kappa u for u = 2^-24.
Decimal6 times_u(const Rational& kappa) { return round_up(Rational(kappa / (mpz_class(1) << 24))); }

const Query<float> by_hand{{3, 4, 0}, {5, 1, 2}, {0, 7, -1}, {1, 0, 0}, 2};

TEST(ConditionTest, HandValueOfARadiusComparison) {
  // m = |A - P|^2 - r^2 = 16 with A - P = (2, 4, 0): |3 4| + |4 8| + |1 (-4)| + |2 (-4)| = 56.
  const Condition found = condition(Formulae::published, by_hand, Comparison::vertex_a_radius);
  EXPECT_EQ(found.kind, Kind::finite);
  EXPECT_FALSE(found.ill_conditioned);
  EXPECT_EQ(found.kappa_u, times_u(Rational(56, 16)));
}

TEST(ConditionTest, HandValueOfASideComparison) {
  // m = a.b - a.a = -8 with a = A - P, b = B - P: dm/dA = b - 2a = (0, -7, 2), dm/dB = a, dm/dP = -(2, -3, 2):
  // 0 + 28 + 0, then 10 + 4 + 0, then 2: 44.
  EXPECT_EQ(condition(Formulae::published, by_hand, Comparison::vertex_a_side_b).kappa_u, times_u(Rational(44, 8)));
}

TEST(ConditionTest, HandValueOfARoot) {
  // m = sqrt(20) - 2: (6 + 16 + 2) / sqrt(20) + 2.
  const Condition found = condition(Formulae::ladder_0, by_hand, Comparison::vertex_a_radius);
  const double root = std::sqrt(20.0), kappa = (24 / root + 2) / (root - 2);
  EXPECT_EQ(found.kind, Kind::finite);
  EXPECT_NEAR(std::ldexp(found.kappa_u.value(), 24) / kappa, 1, 1e-5);
}

// A = (1, 0, 0), P = 0, r = 1 - k u: kappa of sqrt(A.A) > r is (2 - k u) / (k u), so that kappa u >= 1 for k = 1 and,
// by one part in 2^23, not for k = 2, although six digits show 1.
TEST(ConditionTest, IsDecidedWhereSixDigitsDoNotTell) {
  for (const int k : {1, 2}) {
    const float r = 1 - static_cast<float>(k) * 0x1p-24f;
    const Query<float> q{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 0, 0}, r};
    const Condition found = condition(Formulae::ladder_0, q, Comparison::vertex_a_radius);
    EXPECT_EQ(found.ill_conditioned, k == 1);
    EXPECT_EQ(found.kappa_u.value(), k == 1 ? 2 : 1);
  }
}

TEST(ConditionTest, TiesAndPlacesWithoutAMargin) {
  // Vertex A at distance 2 = r; B = C, so there is no plane; P on the extension of the line BA, at distance 0 from it.
  const Query<float> q{{2, 0, 0}, {3, 0, 0}, {3, 0, 0}, {0, 0, 0}, 2};
  for (const Formulae formulae : {Formulae::published, Formulae::ladder_0}) {
    const Condition tie = condition(formulae, q, Comparison::vertex_a_radius);
    EXPECT_EQ(tie.kind, Kind::infinite);
    EXPECT_TRUE(tie.ill_conditioned);
  }
  EXPECT_EQ(condition(Formulae::published, q, Comparison::plane_radius).kind, Kind::infinite) << "0 > 0";
  EXPECT_EQ(condition(Formulae::ladder_0, q, Comparison::plane_radius).kind, Kind::undefined) << "0 / 0";
  EXPECT_EQ(condition(Formulae::ladder_0, q, Comparison::edge_ab_radius).kind, Kind::not_decided) << "sqrt at 0";
  EXPECT_EQ(condition(Formulae::reduced, q, Comparison::edge_ab_radius).kind, Kind::finite);
}

// m at 250 bits after a relative change h of the coordinate `place`.
template <class F>
Floating margin_at(const Query<float>& q, std::size_t which, std::size_t place, double h) {
  auto x = coordinates(q);
  std::array<Floating, coordinate_count> moved;
  for (std::size_t i = 0; i < coordinate_count; ++i) moved[i] = Floating(static_cast<double>(x[i]));
  moved[place] = moved[place] * (Floating(1) + Floating(h));
  const auto dual = from_coordinates(moved);
  const auto sides = sides_of<F>(portable::Problem<Floating>{dual.a, dual.b, dual.c, dual.p, dual.r, Floating(0)});
  return sides.lhs[which] - sides.rhs[which];
}

template <class F>
void expect_finite_differences(Formulae formulae, const Query<float>& q, const std::string& what) {
  const FloatingScope scope({250, Rounding::nearest, {}});
  const auto found = conditions(formulae, q, 0xffff);
  constexpr double h = 0x1p-70;
  for (std::size_t which = 0; which < comparison_count; ++which) {
    if (found[which].kind != Kind::finite) continue;
    Floating sum(0);
    for (std::size_t i = 0; i < coordinate_count; ++i) {
      sum = sum + magnitude(margin_at<F>(q, which, i, h) - margin_at<F>(q, which, i, -h)) / Floating(2 * h);
    }
    const Floating kappa = sum / magnitude(margin_at<F>(q, which, 0, 0));
    const double expected = mpfr_get_d(kappa.get(), MPFR_RNDN);
    EXPECT_NEAR(std::ldexp(found[which].kappa_u.value(), 24) / expected, 1, 1e-5)
        << what << ", " << name(formulae) << ", " << comparisons[which].name;
    EXPECT_GE(std::ldexp(found[which].kappa_u.value(), 24), 1 - 1e-5) << "m is homogeneous, of degree 1 at least";
  }
}

TEST(ConditionTest, AgreesWithFiniteDifferencesInEveryFormula) {
  std::mt19937_64 random(21);
  for (int trial = 0; trial < 20; ++trial) {
    std::array<float, coordinate_count> x;
    for (float& v : x) v = std::ldexp(static_cast<float>(static_cast<int>(random() % 4001) - 2000), -9);
    x.back() = std::fabs(x.back());
    const auto q = from_coordinates(x);
    const std::string what = "query " + std::to_string(trial) + " of seed 21";
    const auto check = [&]<Formulae formulae>() {
      if constexpr (has_comparisons(formulae)) expect_finite_differences<FormulaeType<formulae>>(formulae, q, what);
    };
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (check.template operator()<static_cast<Formulae>(i)>(), ...);
    }(std::make_index_sequence<formulae_count>());
  }
}

// The same decision in MPFR, at a precision at which the inexact flag remains clear: every term is of degree 6 at most.
template <int Bits, class F, class Real>
void expect_same_decisions(Formulae formulae, const Query<Real>& q, const std::string& what) {
  using Number = Mpfr<Bits>;
  mpfr_clear_inexflag();
  const auto sides = sides_of<F>(dual_problem<Number>(q, [](Real x) { return Number(static_cast<double>(x)); }));
  const auto found = conditions(formulae, q, 0xffff);
  const auto x = coordinates(q);
  for (std::size_t which = 0; which < comparison_count; ++which) {
    const auto &lhs = sides.lhs[which], &rhs = sides.rhs[which];
    const Number margin = magnitude(lhs.value - rhs.value), zero;
    Number sum;
    for (std::size_t i = 0; i < coordinate_count; ++i) {
      sum = sum + magnitude(Number(static_cast<double>(x[i])) * (lhs.partials[i] - rhs.partials[i]));
    }
    const Number one_over_u(std::ldexp(1.0, std::numeric_limits<Real>::digits));
    EXPECT_EQ(found[which].kind == Kind::finite, margin > zero) << what;
    EXPECT_EQ(found[which].ill_conditioned, sum >= margin * one_over_u || !(margin > zero))
        << what << ", " << comparisons[which].name;
  }
  EXPECT_FALSE(mpfr_inexflag_p()) << what;
}

// Radii within a few floats of a vertex's distance: kappa u on both sides of 1.
template <int Bits, class Real>
void compare_with_mpfr(int trials) {
  std::mt19937_64 random(22);
  int ill = 0, well = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::array<Real, coordinate_count> x;
    for (Real& v : x)
      v = std::ldexp(static_cast<Real>(static_cast<int>(random() >> 32)), static_cast<int>(random() % 60) - 60);
    auto q = from_coordinates(x);
    const auto a = q.a - q.p;
    q.r = std::sqrt(dot(a, a));
    for (auto steps = random() % 8; steps > 0; --steps) q.r = std::nextafter(q.r, std::numeric_limits<Real>::max());
    const std::string what = "query " + std::to_string(trial) + " of seed 22";
    expect_same_decisions<Bits, portable::PublishedFormulae>(Formulae::published, q, what);
    expect_same_decisions<Bits, portable::ReducedFormulae>(Formulae::reduced, q, what);
    ++(condition(Formulae::published, q, Comparison::vertex_a_radius).ill_conditioned ? ill : well);
  }
  EXPECT_GT(ill, 0);
  EXPECT_GT(well, 0);
}
TEST(ConditionTest, IsDecidedAsByMpfrBinary32) { compare_with_mpfr<1700, float>(60); }
TEST(ConditionTest, IsDecidedAsByMpfrBinary64) { compare_with_mpfr<12700, double>(8); }

}  // namespace
}  // namespace axiscert
