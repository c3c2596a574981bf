// Enclosures without a limit on the range: whatever they call certain is true, for numbers of any exponents; and they
// decide enough.
#include "exact/sphere_triangle/oracles/wide_margins.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "exact/judge/side_error.h"
#include "exact/numbers/rational.h"
#include "exact/sphere_triangle/oracles/vertex_sides.h"
#include "kernel/kernel.h"
#include "kernel/random_testing.h"
#include "kernel/sphere_triangle/forms/scalar.h"

namespace axiscert {
namespace {

using testing_support::random_query;

// A power of two of any exponent that binary64 has, times a number of few bits or of all.
double operand(std::mt19937_64& random) {
  const auto significand = static_cast<double>(static_cast<std::int64_t>(random()) >> (random() % 64));
  return std::ldexp(significand, static_cast<int>(random() % 2098) - 1137);
}

// Sums, differences and products up to degree 6 of numbers of very different and of similar sizes, each compared with
// its rational value.
TEST(WideEnclosed, EnclosesTheRational) {
  constexpr int seed = 31;
  std::mt19937_64 random(seed);
  int narrow = 0, zero = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::pair<WideEnclosed, Rational>> known;
    std::vector<int> degrees;
    for (int k = 0; k < 4; ++k) {
      const double x = operand(random);
      const bool near = random() % 2 == 0;
      const double y = near ? std::nextafter(x, 0.0) * (random() % 2 == 0 ? 1 : 0.5) : operand(random);
      known.emplace_back(WideEnclosed::difference(x, y), exact(x) - exact(y));
      degrees.push_back(1);
    }
    for (int k = 0; k < 12; ++k) {
      const std::size_t a = random() % known.size(), b = random() % known.size();
      const auto [u, exact_u] = known[a];
      const auto [v, exact_v] = known[b];
      if (random() % 2 == 0 && degrees[a] + degrees[b] <= 6) {
        // Rescaled to [1, 2), as the factors of a product of sums are.
        known.emplace_back(u * v + WideEnclosed(), exact_u * exact_v);
        degrees.push_back(degrees[a] + degrees[b]);
      } else {
        const bool minus = random() % 2 == 0;
        known.emplace_back(minus ? u - v : u + v, minus ? Rational(exact_u - exact_v) : Rational(exact_u + exact_v));
        degrees.push_back(std::max(degrees[a], degrees[b]));
      }
      const auto& [found, expected] = known.back();
      const Rational off = abs(expected - times_power(exact(found.value), found.exponent));
      ASSERT_LE(off, times_power(exact(found.error) * exact(1 + 0x1p-40), found.exponent)) << i << " of seed " << seed;
      ASSERT_TRUE(!found.is_positive() || sgn(expected) > 0);
      ASSERT_TRUE(!found.is_negative() || sgn(expected) < 0);
      ASSERT_TRUE(!found.is_zero() || sgn(expected) == 0);
      const Rational size = abs(expected);
      ASSERT_LE(times_power(exact(found.least()), found.exponent), size);
      ASSERT_GE(times_power(exact(found.greatest()), found.exponent), size);
      narrow += found.error <= 0x1p-40 * std::fabs(found.value);
      zero += found.is_zero();
    }
  }
  EXPECT_GT(narrow, 30000);
  EXPECT_GT(zero, 10);
}

// Queries of arbitrary bits; of one size, at any power of two; and with vertices or the centre repeated.
template <class Real>
Query<Real> wide_query(std::mt19937_64& random, int kind) {
  using Limits = std::numeric_limits<Real>;
  auto v = coordinates(random_query<Real>(random, kind % 3 == 0));
  const int size = static_cast<int>(random() % (Limits::max_exponent - Limits::min_exponent)) + Limits::min_exponent;
  for (Real& x : v) {
    if (!std::isfinite(x)) x = 1;
    if (kind % 3 == 1) x = std::ldexp(x, size - 2);
  }
  v[12] = std::abs(v[12]);
  Query<Real> q = from_coordinates(v);
  if (kind % 5 == 0) q.b = q.a;
  if (kind % 35 == 0) q.c = q.a;
  if (kind % 11 == 0) q.p = q.a;
  return q;
}

template <class Real>
class WideMarginsTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(WideMarginsTest, Reals);

template <class Real>
void expect_exact_signs(int count) {
  constexpr int seed = 5;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  int decided = 0, ties = 0;
  for (int i = 0; i < count; ++i) {
    const Query<Real> q = wide_query<Real>(random, i);
    const auto found = WideMargins(widened(q)).signs();
    if (!found) continue;
    const ExactSides truth = exact_sides(q);
    ASSERT_EQ(found->strict, truth.strict) << "query " << i;
    ASSERT_EQ(found->ties, truth.ties) << "query " << i;
    ++decided;
    ties += truth.ties != 0;
  }
  EXPECT_GT(decided, count * 95 / 100);
  EXPECT_GT(ties, count / 5);
}

TYPED_TEST(WideMarginsTest, SignsAreExact) { expect_exact_signs<TypeParam>(3000); }

template <class Real>
class WideMarginsLong : public testing::Test {};
TYPED_TEST_SUITE(WideMarginsLong, Reals);
TYPED_TEST(WideMarginsLong, SignsAreExact) { expect_exact_signs<TypeParam>(200000); }

TYPED_TEST(WideMarginsTest, ErrorsAreWithinTheirBounds) {
  using Real = TypeParam;
  constexpr int seed = 6, count = 600, digits = std::numeric_limits<Real>::digits;
  std::mt19937_64 random(seed);
  int compared = 0, finite = 0, narrow = 0;
  for (const char* id : {"published", "reduced"}) {
    const Kernel& kernel = find_kernel(id);
    const EdgeSides sides = formulae_of(kernel) == Formulae::published ? EdgeSides::published : EdgeSides::reduced;
    for (int i = 0; i < count; ++i) {
      const Query<Real> q = wide_query<Real>(random, i);
      Sides<Real> computed;
      reference(formulae_of(kernel), Arithmetic::plain, Strictness::strict, q, &computed);
      const WideMargins margins(widened(q));
      const ExactSides truth = exact_sides(formulae_of(kernel), q);
      for (std::size_t k = 0; k < comparison_count; ++k) {
        const SideError error(computed.lhs[k], computed.rhs[k], truth.comparison(k));
        if (error.kind() == SideError::Kind::range_event) continue;
        const auto [lower, upper, exponent_above] =
            margins.error(static_cast<Comparison>(k), sides, computed.lhs[k], computed.rhs[k], digits);
        const auto where = testing::Message() << id << " query " << i << " " << comparisons[k].name << " seed " << seed;
        ++compared;
        if (error.kind() == SideError::Kind::without_scale) {
          ASSERT_EQ(upper, std::numeric_limits<double>::infinity()) << where;
          continue;
        }
        const Fraction exact_error = error.exact();
        const Rational expected(exact_error.numerator, exact_error.denominator);
        ASSERT_LE(exact(lower), expected) << where;
        ASSERT_TRUE(!std::isfinite(upper) || exact(upper) >= expected) << where;
        ASSERT_LT(expected, times_power(Rational(1), std::min(exponent_above, 100000))) << where;
        finite += std::isfinite(upper);
        narrow += upper <= lower * (1 + 0x1p-20);
      }
    }
  }
  EXPECT_GT(compared, count * 10);
  EXPECT_GT(finite, compared / 2);
  EXPECT_GT(narrow, compared / 8);
}

TYPED_TEST(WideMarginsTest, VertexSidesAreThoseOfAllSixteen) {
  std::mt19937_64 random(8);
  for (int i = 0; i < 300; ++i) {
    const auto q = wide_query<TypeParam>(random, i);
    const ExactSides truth = exact_sides(i % 2 == 0 ? Formulae::published : Formulae::reduced, q);
    int compared = 0;
    for (std::size_t k = 0; k < comparison_count; ++k) {
      if (!is_of_vertex(k)) continue;
      const VertexSides sides(q, k);
      ASSERT_TRUE(sides.comparison().lhs == truth.lhs[k]) << comparisons[k].name << " query " << i;
      ASSERT_TRUE(sides.comparison().rhs == truth.rhs[k]) << comparisons[k].name << " query " << i;
      ++compared;
    }
    ASSERT_EQ(compared, 9);
  }
}

}  // namespace
}  // namespace axiscert
