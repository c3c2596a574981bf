// The error bounds of double-doubles and enclosed numbers, checked against rationals: cancellation, underflow and low
// parts of every size.
#include "exact/numbers/enclosed.h"

#include <gtest/gtest.h>

#include <random>

#include "exact/numbers/rational.h"

namespace axiscert {
namespace {

using DoublePair = DoubleDouble<double>;

Rational value(double x) { return exact(x); }
Rational value(const DoublePair& x) { return exact(x.high) + exact(x.low); }

// Numbers in pairs that may nearly cancel, with exponents within [-range, range].
template <class T>
class DrawnNumbers {
 public:
  explicit DrawnNumbers(std::uint64_t seed, int range) : random_(seed), range_(range) {}
  T next() {
    const double high =
        near_last() ? -last_ * (1 + std::ldexp(double(integer(-3, 3)), -52)) : fraction(integer(-range_, range_));
    last_ = high;
    if constexpr (std::is_same_v<T, double>) return high;
    else return {high, low_part(high)};
  }

 private:
  int integer(int least, int greatest) { return std::uniform_int_distribution(least, greatest)(random_); }
  bool near_last() { return integer(0, 2) == 0; }
  double fraction(int exponent) {
    const auto bits = static_cast<std::int64_t>(random_()) >> integer(0, 40);
    return std::ldexp(static_cast<double>(bits), exponent - 63);
  }
  // Zero, half an ulp, or any smaller number.
  double low_part(double high) {
    const double most = std::fabs(high) * 0x1p-53 * (1 - 0x1p-52);
    switch (integer(0, 3)) {
      case 0:
        return 0;
      case 1:
        return integer(0, 1) != 0 ? most : -most;
      default:
        return std::ldexp(most * static_cast<double>(integer(-1000, 1000)) / 1000,
                          integer(0, 3) == 0 ? -integer(0, 300) : 0);
    }
  }
  std::mt19937_64 random_;
  int range_;
  double last_ = 1;
};

template <class T>
class EnclosedNumbers : public testing::Test {};
using NumberTypes = testing::Types<double, DoublePair>;
TYPED_TEST_SUITE(EnclosedNumbers, NumberTypes);

template <class T>
void expect_normalized(const T& x) {
  if constexpr (std::is_same_v<T, DoublePair>) {
    EXPECT_EQ(x.high + x.low, x.high);
  }
}

// Expects a normalized number and |computed - exactly| <= bound more.
template <class T>
void expect_within(const T& computed, const Rational& exactly, double bound, std::string_view what, int trial) {
  expect_normalized(computed);
  EXPECT_LE(abs(Rational(value(computed) - exactly)), exact(bound) * exact(more))
      << what << ", trial " << trial << " of seed 41";
}

TYPED_TEST(EnclosedNumbers, OperationsErrAsStated) {
  using T = TypeParam;
  for (const int range : {0, 40, 150, 460}) {
    DrawnNumbers<T> numbers(41, range);
    for (int trial = 0; trial < 2'500; ++trial) {
      const T a = numbers.next(), b = numbers.next();
      const T sum = a + b, product = a * b;
      expect_within(sum, value(a) + value(b), sum_error(a, b, sum), "sum", trial);
      expect_within(product, value(a) * value(b), product_error(product), "product", trial);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TYPED_TEST(EnclosedNumbers, ProductsOfVectorsErrAsStated) {
  using T = TypeParam;
  for (const int range : {0, 40, 150, 460}) {
    DrawnNumbers<T> numbers(41, range);
    const auto vector = [&](double error) {
      const portable::Vec3<T> v{numbers.next(), numbers.next(), numbers.next()};
      return enclosed(v, error);
    };
    for (int trial = 0; trial < 1'500; ++trial) {
      const auto u = vector(0), v = vector(0);
      const auto at = [](const auto& x) { return std::array{value(x.value.x), value(x.value.y), value(x.value.z)}; };
      const auto [ux, uy, uz] = at(u);
      const auto [vx, vy, vz] = at(v);
      const auto scalar = dot(u, v);
      const auto normal = cross(u, v);
      expect_within(scalar.value, Rational(ux * vx + uy * vy + uz * vz), scalar.error, "dot", trial);
      expect_within(normal.value.x, Rational(uy * vz - uz * vy), normal.error, "cross.x", trial);
      expect_within(normal.value.y, Rational(uz * vx - ux * vz), normal.error, "cross.y", trial);
      expect_within(normal.value.z, Rational(ux * vy - uy * vx), normal.error, "cross.z", trial);
      EXPECT_TRUE(scalar.low() <= scalar.high());
      if (testing::Test::HasFailure()) return;
    }
  }
}

// Enclosures of ranges: results enclose every value that the operands' ranges can give.
TYPED_TEST(EnclosedNumbers, CarryTheErrorsOfTheirOperands) {
  using T = TypeParam;
  DrawnNumbers<T> numbers(41, 30);
  std::mt19937_64 random(43);
  for (int trial = 0; trial < 1'500; ++trial) {
    const auto wide = [&] {
      const T x = numbers.next();
      return EnclosedNumber<T>{x, std::ldexp(std::fabs(leading(x)), -static_cast<int>(random() % 60))};
    };
    const EnclosedNumber<T> a = wide(), b = wide();
    const Rational a_end = value(a.value) + exact(a.error) * (random() % 2 ? 1 : -1);
    const Rational b_end = value(b.value) + exact(b.error) * (random() % 2 ? 1 : -1);
    for (const auto& [found, exactly] :
         {std::pair{a + b, Rational(a_end + b_end)}, std::pair{a - b, Rational(a_end - b_end)},
          std::pair{a * b, Rational(a_end * b_end)}}) {
      expect_within(found.value, exactly, found.error, "ends", trial);
      EXPECT_LE(exact(found.low()), exactly);
      EXPECT_GE(exact(found.high()), exactly);
      EXPECT_LE(exact(as_double(found).low()), exactly);
      EXPECT_GE(exact(as_double(found).high()), exactly);
    }
    const EnclosedVector<T> u = enclosed(portable::Vec3<T>{a.value, b.value, a.value}, std::min(a.error, b.error));
    const Rational e = exact(u.error);
    const Rational x = value(a.value) + e, y = value(b.value) - e, z = value(a.value) - e;
    expect_within(dot(u, u).value, Rational(x * x + y * y + z * z), dot(u, u).error, "dot of ends", trial);
    const EnclosedVector<T> v = enclosed(portable::Vec3<T>{b.value, a.value, b.value}, std::max(a.error, b.error));
    const Rational f = exact(v.error);
    const Rational vy = value(a.value) + f, vz = value(b.value) + f;
    expect_within(cross(u, v).value.x, Rational(y * vz - z * vy), cross(u, v).error, "cross of ends", trial);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(DoubleDoubles, ProductsAreExact) {
  DrawnNumbers<double> numbers(41, 400);
  for (int trial = 0; trial < 2'500; ++trial) {
    const double a = numbers.next(), b = numbers.next();
    const auto product = exact_product(a, b);
    EXPECT_EQ(product.value, a * b);
    if (std::fabs(product.value) < 0x1p-900) continue;
    EXPECT_EQ(exact(product.value) + exact(product.error), exact(a) * exact(b)) << "trial " << trial << " of seed 41";
  }
}

}  // namespace
}  // namespace axiscert
