// The numbers of the certified predicate's exact step compared with GMP: integers, balanced digits and balls.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "exact/numbers/rational.h"
#include "kernel/sphere_triangle/certified/balanced_digits.h"
#include "kernel/sphere_triangle/certified/ball.h"
#include "kernel/sphere_triangle/certified/integer.h"

namespace axiscert::certified {
namespace {

constexpr std::uint64_t seed = 1074;

mpz_class power_of_two(int exponent) {
  mpz_class x = 1;
  return x << exponent;
}
// The value of x in units of the least double.
mpz_class in_units(double x) { return mpz_class(mpq_class(x) * power_of_two(1074)); }

// A double of arbitrary bits, of few bits at any exponent, or at the ends of the range.
double any_double(std::mt19937_64& random) {
  switch (random() % 4) {
    case 0: {
      const auto x = std::bit_cast<double>(random());
      return std::isfinite(x) ? x : 0;
    }
    case 1:
      return std::ldexp(static_cast<double>(random() % 16) - 8, static_cast<int>(random() % 2093) - 1074);
    case 2: {
      constexpr double ends[] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min(),
                                 std::numeric_limits<double>::min(), 0x1p1023, 0};
      return ends[random() % 5] * (random() % 2 ? 1 : -1);
    }
    default:
      return static_cast<double>(random() % 1000);
  }
}

template <int degree>
mpz_class value(const BalancedDigits<degree>& x) {
  mpz_class sum = 0;
  for (int i = 0; i < x.size; ++i) sum += mpz_class(static_cast<long>(x.digit[i])) << (x.place[i] * x.base_bits);
  return sum;
}
template <int degree>
void expect_is(const BalancedDigits<degree>& x, const mpz_class& expected) {
  EXPECT_EQ(value(x), expected);
  ASSERT_LE(x.size, x.most);
  for (int i = 0; i < x.size; ++i) {
    EXPECT_NE(x.digit[i], 0);
    EXPECT_GE(x.digit[i], -(std::int64_t{1} << 55));
    EXPECT_LT(x.digit[i], std::int64_t{1} << 55);
    EXPECT_TRUE(i == 0 || x.place[i - 1] < x.place[i]);
  }
  EXPECT_EQ(x.is_zero(), expected == 0);
  EXPECT_EQ(x.is_positive(), expected > 0);
  EXPECT_EQ(x.is_negative(), expected < 0);
}

template <class Number>
Vector<Number> vector_of(const Number (&q)[13], int i) {
  return {q[i], q[i + 1], q[i + 2]};
}
mpz_class dot(const Vector<mpz_class>& u, const Vector<mpz_class>& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
Vector<mpz_class> cross(const Vector<mpz_class>& u, const Vector<mpz_class>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

// The values from which a margin of degree 6 is made: of the greatest degree, from the greatest numbers.
TEST(BalancedDigits, AreTheIntegersOfGmp) {
  std::mt19937_64 random(seed);
  for (int i = 0; i < 4'000; ++i) {
    SCOPED_TRACE(testing::Message() << "trial " << i << " of seed " << seed);
    BalancedDigits<1> q[13];
    mpz_class exact[13];
    for (int k = 0; k < 13; ++k) {
      const double x = any_double(random);
      q[k] = digits_of(Dyadic(x));
      exact[k] = in_units(x);
      expect_is(q[k], exact[k]);
    }
    const auto A = vector_of(q, 0) - vector_of(q, 9), B = vector_of(q, 3) - vector_of(q, 0),
               C = vector_of(q, 6) - vector_of(q, 0);
    const auto a = vector_of(exact, 0) - vector_of(exact, 9), b = vector_of(exact, 3) - vector_of(exact, 0),
               c = vector_of(exact, 6) - vector_of(exact, 0);
    expect_is(A.x, a.x);
    const auto V = certified::cross<BalancedDigits<2>>(B, C);
    const auto v = cross(b, c);
    expect_is(V.x, v.x);
    expect_is(V.y, v.y);
    expect_is(V.z, v.z);
    const auto d = certified::dot<BalancedDigits<3>>(A, V);
    expect_is(d, dot(a, v));
    const auto rr = product<BalancedDigits<2>>(q[12], q[12]);
    const auto vv = certified::dot<BalancedDigits<4>>(V, V);
    expect_is(vv, dot(v, v));
    expect_is(vv - vv, 0);
    expect_is(difference_of_products<BalancedDigits<6>>(d, d, rr, vv),
              dot(a, v) * dot(a, v) - exact[12] * exact[12] * dot(v, v));
  }
}
TEST(BalancedDigits, AreFewOfNumbersFarApart) {
  EXPECT_EQ((digits_of(Dyadic(0x1p1000)) - digits_of(Dyadic(1))).size, 2);
  EXPECT_EQ((digits_of(Dyadic(1)) - digits_of(Dyadic(std::numeric_limits<double>::denorm_min()))).size, 2);
}

void expect_holds(const Ball& ball, const mpq_class& exact) {
  const mpq_class low = times_power(mpq_class(static_cast<long>(ball.middle - ball.error)), ball.exponent),
                  high = times_power(mpq_class(static_cast<long>(ball.middle + ball.error)), ball.exponent);
  EXPECT_LE(low, exact);
  EXPECT_GE(high, exact);
  EXPECT_LE(ball.error, (std::int64_t{1} << 62) + 1);
  EXPECT_LE(std::abs(ball.middle), (std::int64_t{1} << 62) + 1);
  EXPECT_TRUE(!ball.is_positive() || exact > 0);
  EXPECT_TRUE(!ball.is_negative() || exact < 0);
  EXPECT_TRUE(!ball.is_at_least_zero() || exact >= 0);
  EXPECT_TRUE(!ball.is_at_most_zero() || exact <= 0);
}

// Sums, differences and products of the balls made so far.
TEST(Ball, HoldsTheExactValue) {
  std::mt19937_64 random(seed);
  int certain = 0, all = 0;
  for (int i = 0; i < 4'000; ++i) {
    SCOPED_TRACE(testing::Message() << "trial " << i << " of seed " << seed);
    Ball ball[16];
    mpq_class exact[16];
    int degree[16];
    for (int k = 0; k < 16; ++k) {
      if (k < 6) {
        const double x = any_double(random);
        ball[k] = Ball(Dyadic(x));
        exact[k] = x;
        degree[k] = 1;
      } else {
        const int m = static_cast<int>(random() % k), n = static_cast<int>(random() % k);
        const int operation = static_cast<int>(random() % 3);
        const bool is_product = operation == 2 && degree[m] + degree[n] <= 8;
        ball[k] = is_product ? ball[m] * ball[n] : operation == 0 ? ball[m] + ball[n] : ball[m] - ball[n];
        exact[k] = is_product       ? mpq_class(exact[m] * exact[n])
                   : operation == 0 ? mpq_class(exact[m] + exact[n])
                                    : mpq_class(exact[m] - exact[n]);
        degree[k] = is_product ? degree[m] + degree[n] : std::max(degree[m], degree[n]);
      }
      expect_holds(ball[k], exact[k]);
      ++all;
      certain += ball[k].is_positive() || ball[k].is_negative() || (ball[k].middle == 0 && ball[k].error == 0);
    }
  }
  EXPECT_GT(certain, all * 9 / 10) << "balls of seed " << seed << " are too wide to be of use";
}
TEST(Ball, IsExactOfFewBits) {
  const Ball five(Dyadic(5)), three(Dyadic(3));
  const Ball zero = five * three - (five + five + five);
  EXPECT_TRUE(zero.is_at_least_zero() && zero.is_at_most_zero());
}
TEST(Ball, IsAsNarrowAsItsBitsAllow) {
  const Ball wide = Ball(Dyadic(0x1p1000)) + Ball(Dyadic(1));
  EXPECT_TRUE((wide * wide - Ball(Dyadic(0x1p1000)) * wide * Ball(Dyadic(0.999999999999999))).is_positive());
}

// An integer of any size, to be multiplied; negative ones occur too.
template <std::size_t words>
Integer<words> any_integer(std::mt19937_64& random) {
  Integer<words> x{};
  const std::size_t used = random() % (words + 1);
  for (std::size_t i = 0; i < used; ++i) x.word[i] = random() % 4 ? random() : random() % 2 ? 0 : ~std::uint64_t{0};
  if (used == words) x.word[words - 1] >>= 2;
  return random() % 2 ? Integer<words>{} - x : x;
}
template <std::size_t words>
mpz_class value(const Integer<words>& x) {
  mpz_class sum = 0;
  for (std::size_t i = words; i-- > 0;) sum = (sum << 64) + mpz_class(static_cast<unsigned long>(x.word[i]));
  return x.is_negative() ? mpz_class(sum - power_of_two(64 * static_cast<int>(words))) : sum;
}
// x without its words above the first `kept`, the last of them without its sign.
template <std::size_t kept, std::size_t words>
Integer<words> first_words(Integer<words> x) {
  for (std::size_t i = kept; i < words; ++i) x.word[i] = 0;
  x.word[kept - 1] &= ~std::uint64_t{0} >> 2;
  return x;
}
// The integers at which a carry or a borrow goes through every word, or a sign changes; and any others.
template <std::size_t words>
Integer<words> edge_integer(std::mt19937_64& random) {
  Integer<words> x{};
  const int top = static_cast<int>(64 * words) - 1;
  switch (random() % 6) {
    case 0:  // 0, 1, -1
      return shifted<Integer<words>>(random() % 2, 0, random() % 2);
    case 1:  // the greatest and the least
      x.word[words - 1] = std::uint64_t{1} << 63;
      return random() % 2 ? x : x - shifted<Integer<words>>(1, 0, false);
    case 2:  // a power of two, or one off
      x = shifted<Integer<words>>(1, static_cast<unsigned>(random() % static_cast<unsigned>(top)), random() % 2);
      return random() % 2 ? x : x - shifted<Integer<words>>(1, 0, random() % 2);
    default:
      return any_integer<words>(random);
  }
}
// Sums and differences that fit; modulo 2^(64 words) where they do not, which no caller asks.
template <std::size_t... words>
void expect_sums(std::mt19937_64& random) {
  const auto expect = [&]<std::size_t size>() {
    const mpz_class modulus = power_of_two(64 * static_cast<int>(size)), half = modulus / 2;
    const auto wrapped = [&](mpz_class x) {
      if (x >= half) x -= modulus;
      if (x < -half) x += modulus;
      return x;
    };
    for (int i = 0; i < 4'000; ++i) {
      const auto a = edge_integer<size>(random);
      const auto b = random() % 8 == 0 ? a : edge_integer<size>(random);
      const mpz_class x = value(a), y = value(b), sum = wrapped(x + y), difference = wrapped(x - y);
      ASSERT_EQ(value(a + b), sum) << size << " words, " << x << " and " << y;
      ASSERT_EQ(value(a - b), difference) << size << " words, " << x << " and " << y;
      ASSERT_EQ((a - b).is_negative(), difference < 0) << size << " words, " << x << " and " << y;
      ASSERT_EQ((a - b).is_zero(), difference == 0) << size << " words, " << x << " and " << y;
      ASSERT_EQ((a - b).is_positive(), difference > 0) << size << " words, " << x << " and " << y;
    }
  };
  (expect.template operator()<words>(), ...);
}
// Every size that the exact step has (Integers<n>::bits), and the sizes between.
TEST(Integer, SumsAndDifferencesAreThoseOfGmp) {
  std::mt19937_64 random(seed);
  expect_sums<1, 2, 3, 4, 5, 6, 7, 8, 9, 12>(random);
}

// Products into as many words as they need: `less` fewer than both factors have.
template <std::size_t m, std::size_t n, std::size_t less = 0>
void expect_products(std::mt19937_64& random) {
  for (int i = 0; i < 2'000; ++i) {
    const auto a = any_integer<m>(random);
    auto b = any_integer<n>(random);
    if constexpr (less != 0) {
      b = first_words<n - less>(b);
      if (random() % 2) b = Integer<n>{} - b;
    }
    EXPECT_EQ(value(product<Integer<m + n - less>>(a, b)), value(a) * value(b))
        << m << " words by " << n << ", trial " << i;
  }
}
TEST(Integer, ProductsAreThoseOfGmp) {
  std::mt19937_64 random(seed);
  expect_products<1, 1>(random);
  expect_products<1, 2>(random);
  expect_products<2, 2>(random);
  expect_products<3, 3>(random);
  expect_products<3, 5>(random);
  expect_products<5, 6>(random);
  expect_products<2, 2, 1>(random);
  expect_products<3, 3, 1>(random);
  expect_products<2, 3, 1>(random);
  expect_products<5, 5, 1>(random);
}

}  // namespace
}  // namespace axiscert::certified
