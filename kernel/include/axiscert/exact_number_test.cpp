// The exact number of formulae against GMP's fractions.
#include "exact_number.hpp"

#include <gtest/gtest.h>

#include <cfloat>
#include <random>

namespace axiscert::formulae {
namespace {

// Doubles of every size, small integers and zeros among them.
class Doubles {
 public:
  double operator()() {
    switch (random_() % 4) {
      case 0:
        return static_cast<double>(static_cast<int>(random_() % 9) - 4);
      case 1:
        return std::ldexp(static_cast<double>(random_()), static_cast<int>(random_() % 2000) - 1100);
      default:
        return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random_())), -64);
    }
  }

 private:
  std::mt19937_64 random_{7};
};

TEST(ExactNumber, IsTheFractionThatGmpComputes) {
  Doubles draw;
  for (int i = 0; i < 20000; ++i) {
    const double a = draw(), b = draw(), c = draw(), d = draw();
    const Exact x(a), y(b), z(c), w(d);
    const mpq_class p(a), q(b), r(c), s(d);
    ASSERT_EQ((x * y - z * w).fraction(), mpq_class(p * q - r * s)) << a << ' ' << b << ' ' << c << ' ' << d;
    ASSERT_EQ((x + y).fraction(), mpq_class(p + q)) << a << ' ' << b;
    ASSERT_EQ((-x).fraction(), mpq_class(-p)) << a;
    ASSERT_EQ(abs(x).fraction(), mpq_class(abs(p))) << a;
    ASSERT_EQ(x < y, a < b) << a << ' ' << b;
    ASSERT_EQ(x >= y, a >= b) << a << ' ' << b;
    ASSERT_EQ(x == y, a == b) << a << ' ' << b;
    ASSERT_EQ(x * z > y * w, p * r > q * s) << a << ' ' << b << ' ' << c << ' ' << d;
    if (b == 0 || d == 0) continue;
    ASSERT_EQ((x / y + z / w).fraction(), mpq_class(p / q + r / s)) << a << ' ' << b << ' ' << c << ' ' << d;
    ASSERT_EQ(x / y < z / w, p / q < r / s) << a << ' ' << b << ' ' << c << ' ' << d;
  }
}

TEST(ExactNumber, KeepsTheLeastAndTheGreatestDouble) {
  const Exact least(DBL_TRUE_MIN), greatest(DBL_MAX);
  EXPECT_GT(least * least * least, Exact());
  EXPECT_GT(greatest * greatest + least, greatest * greatest);
  EXPECT_EQ(greatest + least - greatest, least);
  EXPECT_EQ(Exact(-0.0), Exact(0));
}

TEST(ExactNumber, ADivisionByZeroIsUndefined) {
  EXPECT_THROW(Exact(1) / Exact(), Undefined);
  EXPECT_THROW(Exact() / (Exact(0.1) - Exact(0.1)), Undefined);
  EXPECT_EQ(Exact(0) / Exact(-3), Exact());
  EXPECT_LT(Exact(1) / Exact(-3), Exact());
}

}  // namespace
}  // namespace axiscert::formulae
