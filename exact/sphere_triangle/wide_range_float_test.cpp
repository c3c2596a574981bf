// The operations of WideRangeFloat compared with MPFR's at 24 bits, and the bounds that decide for which formulae it is
// used.
#include "exact/sphere_triangle/wide_range_float.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "exact/numbers/mpfr_number.h"

namespace axiscert {
namespace {

// An operand of at most 24 bits, with exponents as in degree 3; often with few bits or a long carry, where midpoints
// and ties occur.
double any_operand(std::mt19937_64& random) {
  constexpr std::int64_t kinds[] = {1, 3, 0x800000, 0x800001, 0xfffffe, 0xffffff};
  const std::uint64_t choice = random() % 12;
  const std::int64_t significand =
      choice < 6 ? kinds[choice] : static_cast<std::int64_t>(random() % 0x1000000 >> (random() % 24));
  const double x = std::ldexp(static_cast<double>(significand), static_cast<int>(random() % 800) - 440);
  return random() % 2 == 0 ? x : -x;
}

TEST(WideRangeFloat, RoundsAsMpfrDoes) {
  constexpr int seed = 91;
  std::mt19937_64 random(seed);
  int ties = 0, rounded = 0;
  for (int i = 0; i < 1000000; ++i) {
    const double x = any_operand(random);
    // Half of the sums are of numbers up to 60 places apart.
    double y = any_operand(random);
    if (i % 2 == 0 && x != 0 && y != 0)
      y = std::ldexp(y, std::ilogb(x) - std::ilogb(y) + static_cast<int>(random() % 121) - 60);
    const auto same = [](const WideRangeFloat& found, const Mpfr<24>& expected) {
      return mpfr_cmp_d(expected.get(), found.value()) == 0;
    };
    const WideRangeFloat a(x), b(y);
    const Mpfr<24> u(x), v(y);
    ASSERT_TRUE(same(a + b, u + v) && same(a - b, u - v) && same(a * b, u * v))
        << std::hexfloat << x << " and " << y << ", seed " << seed;
    ASSERT_TRUE((a > b) == (u > v) && (a >= b) == (u >= v));
    const Mpfr<60> sum = Mpfr<60>(x) + Mpfr<60>(y);  // exact if 25 bits hold it
    rounded += mpfr_min_prec(sum.get()) > 24;
    ties += mpfr_min_prec(sum.get()) == 25;
  }
  EXPECT_GT(rounded, 100000);
  EXPECT_GT(ties, 10000);
}

TEST(WideRangeFloat, CoversThePolynomialRungs) {
  const auto covered = [](Formulae formulae) {
    const auto degrees = degrees_of(formulae);
    if (!degrees) return false;
    for (const ComparisonDegree& degree : *degrees) {
      if (!degree.bits || !WideRangeFloat::covers(*degree.bits)) return false;
    }
    return true;
  };
  EXPECT_TRUE(covered(Formulae::published));
  EXPECT_TRUE(covered(Formulae::reduced));
  EXPECT_TRUE(covered(Formulae::reduced_shared));
  EXPECT_TRUE(covered(Formulae::ladder_9));
  EXPECT_FALSE(covered(Formulae::ladder_0)) << "it divides";
  EXPECT_FALSE(WideRangeFloat::covers({7, 0})) << "(2^-149)^7 is subnormal";
  EXPECT_FALSE(WideRangeFloat::covers({6, 256})) << "2^768 2^256 is no binary64";
}

}  // namespace
}  // namespace axiscert
