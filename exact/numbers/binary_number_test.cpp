// Sums, differences, products and order of BinaryNumber and BinaryFraction compared with GMP's rationals.
#include "exact/numbers/binary_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "exact/numbers/binary_fraction.h"

namespace axiscert {
namespace {

// All exponents of finite doubles, and runs of ones and zeros, which carry far or cancel.
double any_exponent(std::mt19937_64& random) {
  const auto exponent = static_cast<int>(random() % 2098) - 1074;
  const double runs[] = {1, 3, 0x1.fffffffffffffp52, 0x1p52, 0x1.00000000001p52};
  const double size = random() % 2 == 0 ? runs[random() % 5] : static_cast<double>(random() >> 11);
  const double x = std::ldexp(size, exponent - 52);
  return random() % 2 == 0 ? x : -x;
}
// Mostly of one size, so that sums overlap.
double of_one_size(std::mt19937_64& random) {
  const double x = std::ldexp(static_cast<double>(random() >> (11 + random() % 40)), -static_cast<int>(random() % 90));
  return random() % 2 == 0 ? x : -x;
}

struct BinaryAndRational {
  BinaryNumber number;
  Rational exactly;
};
BinaryAndRational any_binary_number(std::mt19937_64& random) {
  const bool is_wide = random() % 4 == 0;
  const auto next = [&] { return is_wide ? any_exponent(random) : of_one_size(random); };
  const double first = next();
  BinaryAndRational sum{BinaryNumber(first), exact(first)};
  for (std::uint64_t terms = random() % 6; terms > 0; --terms) {
    const double x = next(), y = random() % 2 == 0 ? 1 : next();
    sum.number = sum.number + BinaryNumber(x) * BinaryNumber(y);
    sum.exactly += exact(x) * exact(y);
  }
  return sum;
}

TEST(BinaryNumber, IsExactInEveryOperation) {
  std::mt19937_64 random(20261124);
  for (int i = 0; i < 4000; ++i) {
    const BinaryAndRational a = any_binary_number(random), b = random() % 16 == 0 ? a : any_binary_number(random);
    ASSERT_EQ(rational(a.number), a.exactly) << i;
    ASSERT_EQ(rational(a.number + b.number), a.exactly + b.exactly) << i;
    ASSERT_EQ(rational(a.number - b.number), a.exactly - b.exactly) << i;
    ASSERT_EQ(rational(a.number * b.number), a.exactly * b.exactly) << i;
    ASSERT_EQ(rational(-a.number), -a.exactly) << i;
    ASSERT_EQ(rational(magnitude(a.number)), abs(a.exactly)) << i;
    const long double near = a.number.approximately();
    ASSERT_EQ(near > 0, a.number.sign() > 0) << i;
    // The two doubles of a long double have all its bits, where neither is too great or subnormal.
    if (std::fabs(near) > 0x1p-900L && std::fabs(near) < 0x1p1000L) {
      const auto leading = static_cast<double>(near);
      const Rational off = exact(leading) + exact(static_cast<double>(near - leading)) - a.exactly;
      ASSERT_LE(abs(off) * exact(0x1p62), abs(a.exactly)) << i;
    }
    const int less_or_greater = cmp(a.exactly, b.exactly);
    ASSERT_EQ(order(a.number, b.number), less_or_greater < 0 ? -1 : less_or_greater > 0 ? 1 : 0) << i;
    ASSERT_EQ(a.number.sign(), sgn(a.exactly)) << i;
    ASSERT_TRUE(a.number + b.number - b.number == a.number) << i;
    // Numbers of which one begins with all words of the other.
    const BinaryNumber least(0x1p-1074), longer = a.number + least * least;
    ASSERT_TRUE(longer > a.number && a.number < longer && -longer < -a.number && !(a.number == longer)) << i;
  }
}

TEST(BinaryNumber, HasAFloatsValueAtEveryExponent) {
  for (int exponent = -1074; exponent < 1024; ++exponent) {
    const double power = std::ldexp(1, exponent), odd = power * (1 + 0x1p-20);
    ASSERT_EQ(rational(BinaryNumber(power)), exact(power)) << exponent;
    if (std::isfinite(odd)) {
      ASSERT_EQ(rational(BinaryNumber(-odd)), exact(-odd)) << exponent;
    }
  }
  EXPECT_EQ(BinaryNumber(-0.0).sign(), 0);
  EXPECT_TRUE(BinaryNumber::one() == BinaryNumber(1));
  EXPECT_EQ(rational(BinaryNumber(mpz_class("-340282366920938463463374607431768211456").get_mpz_t())),
            Rational("-340282366920938463463374607431768211456"));
}

TEST(BinaryNumber, IsCopiedAndMovedWithManyWordsAndWithFew) {
  const BinaryNumber many = BinaryNumber(0x1p1000) + BinaryNumber(0x1p-1000), few(3);
  BinaryNumber a = many, b = few;
  a = std::move(b);
  EXPECT_TRUE(a == few);
  b = many;
  a = b;
  EXPECT_TRUE(a == many);
  const BinaryNumber moved = std::move(a);
  EXPECT_TRUE(moved == many);
  a = few;
  EXPECT_TRUE(a == few && a + many > many);
}

TEST(BinaryFraction, IsExactInEveryOperation) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 1000; ++i) {
    const BinaryAndRational a = any_binary_number(random), b = any_binary_number(random), c = any_binary_number(random),
                            d = any_binary_number(random);
    if (b.number.sign() == 0 || d.number.sign() == 0) continue;
    const bool same = random() % 2 == 0;
    const Rational q = a.exactly / b.exactly, r = c.exactly / (same ? b.exactly : d.exactly);
    const BinaryFraction x = BinaryFraction(a.number) / BinaryFraction(b.number),
                         y = BinaryFraction(c.number) / BinaryFraction(same ? b.number : d.number);
    ASSERT_EQ(rational(x), q) << i;
    ASSERT_EQ(rational(x + y), q + r) << i;
    ASSERT_EQ(rational(x - y), q - r) << i;
    ASSERT_EQ(rational(x * y), q * r) << i;
    ASSERT_EQ(rational(magnitude(x)), abs(q)) << i;
    ASSERT_EQ(x > y, q > r) << i;
    ASSERT_EQ(x >= y, q >= r) << i;
    ASSERT_EQ(x == y, q == r) << i;
    ASSERT_EQ(rational(BinaryFraction(q)), q) << i;
  }
}

}  // namespace
}  // namespace axiscert
