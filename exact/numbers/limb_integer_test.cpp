// Sums, differences and products of LimbInteger compared with GMP's own integers.
#include "exact/numbers/limb_integer.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <random>

namespace axiscert {
namespace {

constexpr std::size_t capacity = 8;
using Integer = LimbInteger<capacity>;

mpz_class value(const auto& x) {
  return x.as_mpz([](mpz_srcptr z) { return mpz_class(z); });
}

// Runs of ones and of zeros, up to six words long: carries that propagate far, and numbers that cancel.
Integer number(std::mt19937_64& random) {
  Integer sum;
  for (std::uint64_t terms = random() % 4; terms > 0; --terms) {
    const auto significand = static_cast<std::int64_t>(random() >> 1) >> (random() % 63);
    const auto shift = static_cast<unsigned>(random() % 320), bits = static_cast<unsigned>(random() % 384);
    const auto term = Integer::shifted(random() % 2 == 0 ? significand : -significand, shift);
    const auto power = Integer::shifted(1, bits);
    sum = sum + term;
    if (random() % 2 == 0) sum = sum + power - Integer(1);
  }
  return sum;
}

TEST(LimbIntegers, AreThoseOfGmp) {
  constexpr int seed = 91;
  std::mt19937_64 random(seed);
  for (int i = 0; i < 100000; ++i) {
    const Integer a = number(random), b = random() % 8 == 0 ? (random() % 2 == 0 ? a : -a) : number(random);
    const mpz_class x = value(a), y = value(b);
    ASSERT_EQ(value(a + b), x + y) << "seed " << seed << ", " << x << " and " << y;
    ASSERT_EQ(value(a - b), x - y) << "seed " << seed << ", " << x << " and " << y;
    ASSERT_EQ(value(a * b), x * y) << "seed " << seed << ", " << x << " and " << y;
    ASSERT_EQ(value(-a), -x);
    ASSERT_EQ(a.is_zero(), x == 0);
    ASSERT_EQ(a.is_negative(), x < 0);
    ASSERT_EQ((a - b).is_negative(), x < y);
    ASSERT_EQ((a - a).is_zero(), true);
  }
}

TEST(LimbIntegers, AreShiftedByAnyNumberOfBits) {
  for (const std::int64_t significand : {std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}, std::int64_t{3},
                                         (std::int64_t{1} << 53) - 1, -(std::int64_t{1} << 53), INT64_MAX, INT64_MIN}) {
    for (unsigned shift = 0; shift <= 64 * (capacity - 1); ++shift) {
      ASSERT_EQ(value(Integer::shifted(significand, shift)), mpz_class(significand) << shift) << shift;
    }
  }
}

// 2^512 - 1, by a sum that fills the last word, and its square.
TEST(LimbIntegers, HoldWhatTheirCapacityHolds) {
  const Integer half = Integer::shifted(1, 64 * capacity - 1);
  const Integer most = half + (half - Integer(1));
  EXPECT_EQ(value(most), (mpz_class(1) << (64 * capacity)) - 1);
  EXPECT_EQ(value(most * most), value(most) * value(most));
  EXPECT_TRUE((most - most).is_zero());
}

}  // namespace
}  // namespace axiscert
