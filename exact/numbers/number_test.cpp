// The number types of the exact and the unbounded evaluations: Surd and Floating.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <bit>
#include <cmath>
#include <random>

#include "exact/numbers/floating.h"
#include "exact/numbers/mpfr_number.h"
#include "exact/numbers/surd.h"

namespace axiscert {
namespace {

Surd surd(double x) { return Surd(BinaryNumber(x)); }

TEST(SurdTest, HandValues) {
  const Surd root2 = square_root(surd(2)), half_root2 = root2 / surd(2);
  const auto equal = [](const Surd& a, const Surd& b) { return a >= b && b >= a && !(a > b); };
  EXPECT_TRUE(equal(root2 * root2, surd(2)));
  EXPECT_TRUE(equal(surd(1) / root2, half_root2));
  EXPECT_TRUE(equal(square_root(surd(0.5)), half_root2));
  EXPECT_TRUE(equal(root2 + root2, square_root(surd(8)))) << "different radicands, one number";
  EXPECT_TRUE(equal(square_root(surd(9)), surd(3)));
  EXPECT_TRUE(equal(root2 - root2, surd(0)));
  EXPECT_TRUE(equal(surd(0) + root2, root2)) << "nothing is added to a root";
  EXPECT_TRUE(equal(magnitude(surd(0) - root2), root2));
  EXPECT_TRUE(equal(surd(-3) / surd(-6), surd(0.5)));
  EXPECT_GT(root2, surd(1.4142135623730949));
  EXPECT_GT(surd(1.4142135623730951), root2);
  EXPECT_GT(surd(1), surd(0) - root2);
}

TEST(SurdTest, WhatIsDividedByZeroIsUndefinedAndSoIsAllThatIsMadeOfIt) {
  const Surd zero = surd(0), one = surd(1), root2 = square_root(surd(2));
  for (const Surd& undefined :
       {zero / zero, one / zero, root2 / zero, one / square_root(zero), one / (root2 - root2)}) {
    EXPECT_TRUE(undefined.is_undefined());
    for (const Surd& made : {undefined + one, one - undefined, undefined * zero, zero / undefined, undefined / one,
                             square_root(undefined), magnitude(undefined), undefined + undefined, zero - undefined}) {
      EXPECT_TRUE(made.is_undefined());
      for (const Surd& other : {zero, one, root2, undefined}) {
        EXPECT_FALSE(made > other || other > made || made >= other || other >= made);
      }
    }
  }
}

TEST(SurdTest, RefusesWhatItIsNotClosedUnder) {
  const Surd root2 = square_root(surd(2)), root3 = square_root(surd(3));
  EXPECT_THROW(root2 + root3, std::logic_error);
  EXPECT_THROW(root2 - surd(1), std::logic_error);
  EXPECT_THROW(root2 * root3, std::logic_error);
  EXPECT_THROW(root2 / root3, std::logic_error);
  EXPECT_THROW(square_root(root2), std::logic_error);
  EXPECT_NO_THROW(EXPECT_GT(root3, root2)) << "different roots have an order";
}

// A Surd and the same value at 400 bits.
struct Both {
  Surd exact;
  Mpfr<400> near;
  bool rooted = false;
};
Both operator+(const Both& a, const Both& b) { return {a.exact + b.exact, a.near + b.near, a.rooted}; }
Both operator-(const Both& a, const Both& b) { return {a.exact - b.exact, a.near - b.near, a.rooted}; }
Both operator*(const Both& a, const Both& b) { return {a.exact * b.exact, a.near * b.near, a.rooted != b.rooted}; }
Both operator/(const Both& a, const Both& b) { return {a.exact / b.exact, a.near / b.near, a.rooted != b.rooted}; }

TEST(SurdTest, HasTheOrderOfAnEvaluationAt400Bits) {
  constexpr int seed = 61;
  std::mt19937_64 random(seed);
  int ties = 0;
  for (int i = 0; i < 400; ++i) {
    // Small numbers, so that values coincide; only numbers of the same kind are added.
    const auto small = [&] { return static_cast<double>(random() % 9) - 4; };
    const double inside = static_cast<double>(random() % 6 + 1) / 4;
    const Both root{square_root(surd(inside)), square_root(Mpfr<400>(inside)), true};
    std::vector<Both> made;
    for (int k = 0; k < 4; ++k) {
      const double x = small();
      made.push_back({surd(x), Mpfr<400>(x)});
      made.push_back(made.back() * root);
    }
    for (int k = 0; k < 12; ++k) {
      const Both a = made[random() % made.size()], b = made[random() % made.size()];
      const bool addable = a.rooted == b.rooted;
      switch (random() % 4) {
        case 0:
          if (addable) made.push_back(a + b);
          break;
        case 1:
          if (addable) made.push_back(a - b);
          break;
        case 2:
          made.push_back(a * b);
          // A product of equal roots is rational and is recorded as such.
          made.back().rooted = !made.back().exact.is_rational();
          break;
        case 3:
          if (!b.exact.numerator().is_zero()) {
            made.push_back(a / b);
            made.back().rooted = !made.back().exact.is_rational();
          }
      }
    }
    for (const Both& a : made) {
      for (const Both& b : made) {
        const Mpfr<400> difference = a.near - b.near;
        // The threshold lies far below any two different values of these few small operations.
        const int sign = order(magnitude(difference), Mpfr<400>(0x1p-300)) < 0 ? 0 : order(difference, Mpfr<400>(0));
        ASSERT_EQ(a.exact > b.exact, sign > 0) << "case " << i << " of seed " << seed;
        ASSERT_EQ(a.exact >= b.exact, sign >= 0) << "case " << i << " of seed " << seed;
        ties += &a != &b && sign == 0;
      }
    }
  }
  EXPECT_GT(ties, 1000);
}

constexpr std::array rounding_modes = {Rounding::nearest, Rounding::upward, Rounding::downward, Rounding::toward_zero};

template <class Real>
Real real(const Floating& x) {
  if constexpr (sizeof(Real) == 4) return mpfr_get_flt(x.get(), MPFR_RNDN);
  else return mpfr_get_d(x.get(), MPFR_RNDN);
}

// Numbers whose operations reach every limit of the range: arbitrary bits, and neighbours of the least and the greatest
// number.
template <class Real>
Real any_number(std::mt19937_64& random) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  using Limits = std::numeric_limits<Real>;
  const Real sign = random() % 2 == 0 ? Real(1) : Real(-1), little = static_cast<Real>(random() % 16);
  switch (random() % 6) {
    case 0:
      return sign * little * Limits::denorm_min();
    case 1:
      return sign * Limits::max() / (1 + little);
    case 2:
      return sign * (1 + little * Limits::epsilon());
    case 3:
      return sign * Limits::min() * (1 + little / 8);
  }
  return std::bit_cast<Real>(static_cast<Bits>(random()));
}

// One operation in the processor's rounding mode: operands and result go through memory, so that the operation stays
// within the scope.
template <class Real>
Real on_hardware(int operation, Rounding rounding, Real a, Real b, Real c) {
  volatile Real x = a, y = b, z = c, result = 0;
  const FloatingEnvironment environment(rounding, false);
  switch (operation) {
    case 0:
      result = x + y;
      break;
    case 1:
      result = x - y;
      break;
    case 2:
      result = x * y;
      break;
    case 3:
      result = x / y;
      break;
    case 4:
      result = std::fma(x, y, z);
      break;
    case 5:
      result = std::sqrt(x);
      break;
    case 6:
      result = std::fabs(x);
      break;
    case 7:
      result = -x;
  }
  return result;
}
Floating in_software(int operation, const Floating& a, const Floating& b, const Floating& c) {
  switch (operation) {
    case 0:
      return a + b;
    case 1:
      return a - b;
    case 2:
      return a * b;
    case 3:
      return a / b;
    case 4:
      return fused(a, b, c);
    case 5:
      return square_root(a);
    case 6:
      return magnitude(a);
  }
  return -a;
}
constexpr int operation_count = 8;

template <class Real>
class FloatingTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(FloatingTest, Reals);

TYPED_TEST(FloatingTest, IsTheHardwareBitForBit) {
  constexpr int seed = 62;
  std::mt19937_64 random(seed);
  int subnormal = 0, infinite = 0;
  for (const Rounding rounding : rounding_modes) {
    const FloatingScope scope({std::numeric_limits<TypeParam>::digits, rounding, precision_of<TypeParam>});
    for (int i = 0; i < 20000; ++i) {
      const TypeParam a = any_number<TypeParam>(random), b = any_number<TypeParam>(random),
                      c = any_number<TypeParam>(random);
      for (int operation = 0; operation < operation_count; ++operation) {
        const TypeParam expected = on_hardware(operation, rounding, a, b, c);
        const TypeParam found = real<TypeParam>(in_software(operation, Floating(a), Floating(b), Floating(c)));
        ASSERT_TRUE(std::isnan(expected) ? std::isnan(found)
                                         : expected == found && std::signbit(expected) == std::signbit(found))
            << std::hexfloat << "operation " << operation << " rounding " << static_cast<int>(rounding) << " of " << a
            << " " << b << " " << c << ": " << found << " for " << expected << ", seed " << seed;
        subnormal += std::fpclassify(expected) == FP_SUBNORMAL;
        infinite += std::isinf(expected);
      }
    }
  }
  EXPECT_GT(subnormal, 1000);
  EXPECT_GT(infinite, 1000);
}

TEST(FloatingFormats, WithoutExponentLimitsIsAnMpfrOf24Bits) {
  constexpr int seed = 63;
  std::mt19937_64 random(seed);
  const FloatingScope scope({24, Rounding::nearest, {}});
  for (int i = 0; i < 20000; ++i) {
    const double a = any_number<float>(random), b = any_number<float>(random);
    // Squared four times: exponents far beyond binary32's.
    Floating x(a), y(b);
    Mpfr<24> u(a), v(b);
    const auto same = [&](const Floating& f, const Mpfr<24>& m) {
      return mpfr_nan_p(f.get()) != 0 ? mpfr_nan_p(m.get()) != 0 : mpfr_equal_p(f.get(), m.get()) != 0;
    };
    for (int k = 0; k < 4; ++k) {
      ASSERT_TRUE(same(x + y, u + v) && same(x - y, u - v) && same(x / y, u / v) &&
                  same(square_root(x), square_root(u)))
          << a << " " << b << ", seed " << seed;
      x = x * x;
      u = u * u;
      ASSERT_TRUE(same(x, u)) << a << " squared " << k << " times, seed " << seed;
    }
  }
}

TEST(FloatingFormats, AScopeEndsAndTheFormatBeforeItIsBack) {
  const auto third = [] { return Floating(1) / Floating(3); };
  const auto least_squared = [] { return Floating(0x1p-149) * Floating(0x1p-149); };
  const FloatingScope outer({53, Rounding::upward, {}});
  EXPECT_EQ(real<double>(third()), 0x1.5555555555556p-2);
  {
    const FloatingScope inner({24, Rounding::downward, Precision::binary32});
    EXPECT_EQ(real<double>(third()), 0x1.555554p-2);
    EXPECT_EQ(real<double>(least_squared()), 0);
    {
      const FloatingScope innermost({11, Rounding::nearest, {}});
      EXPECT_EQ(real<double>(third()), 0x1.554p-2);
    }
    EXPECT_EQ(real<double>(third()), 0x1.555554p-2);
    EXPECT_EQ(real<double>(Floating(1 + 0x1p-40)), 1 + 0x1p-40) << "what is made from a double is not rounded";
  }
  EXPECT_EQ(real<double>(third()), 0x1.5555555555556p-2);
  EXPECT_EQ(real<double>(least_squared()), 0x1p-298) << "the exponents are unbounded again";
}

}  // namespace
}  // namespace axiscert
