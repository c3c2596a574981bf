// Numbers with one root: their order, and their decimals.
#include "exact/numbers/roots.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace axiscert {
namespace {

TEST(RootNumber, IsComparedByItsSquare) {
  const RootNumber less{Rational(3), Rational(2), -1}, more{Rational(-1), Rational(2)};  // 3 - sqrt(2), -1 + sqrt(2)
  EXPECT_GT(compare(less, Rational(3, 2)), 0);
  EXPECT_LT(compare(less, Rational(8, 5)), 0);
  EXPECT_GT(compare(more, 0), 0);
  EXPECT_EQ(compare(RootNumber{Rational(-3), Rational(9)}, 0), 0);
  EXPECT_EQ(compare(RootNumber{Rational(-3), Rational(8)}, 0), -1);
  const RootNumber wide{Rational(mpz_class("12922646869"), 4), Rational(mpz_class("3192085110000000000"), 7), -1};
  EXPECT_EQ(compare(wide, 0), 1);
  EXPECT_EQ(decimal_text(wide, 9), "2.55537499e+09");
}

TEST(RootNumber, DecimalsAreRoundedOnceToEven) {
  const auto text = [](const char* number, int digits) {
    return decimal_text(RootNumber{parse_decimal(number)}, digits);
  };
  EXPECT_EQ(text("0", 9), "0");
  EXPECT_EQ(text("-2.50", 9), "-2.5");
  EXPECT_EQ(text("1234567895", 9), "1.2345679e+09");
  EXPECT_EQ(text("123456789.5", 9), "123456790");
  EXPECT_EQ(text("123456788.5", 9), "123456788");
  EXPECT_EQ(text("123456788.50000000000000000001", 9), "123456789");
  EXPECT_EQ(text("999999999.5", 9), "1e+09");
  EXPECT_EQ(text("0.00012", 9), "0.00012");
  EXPECT_EQ(text("0.000012", 9), "1.2e-05");
  EXPECT_EQ(text("1e300", 17), "1e+300");
  EXPECT_EQ(text("1000", 9), "1000");
  EXPECT_EQ(decimal_text(RootNumber{0, Rational(2)}, 17), "1.414213562373095");
  EXPECT_EQ(decimal_text(RootNumber{0, Rational(2), -1}, 9), "-1.41421356");
  EXPECT_EQ(decimal_text(RootNumber{Rational(1), Rational(1), -1}, 9), "0");
}

// 1e9 - sqrt(1e18 - 1): nothing of it is left where each is rounded first.
TEST(RootNumber, DecimalsOfDifferencesKeepTheirDigits) {
  const RootNumber difference{Rational(1000000000), Rational(mpz_class("999999999999999999")), -1};
  EXPECT_EQ(decimal_text(difference, 17), "5e-10");
  EXPECT_GT(compare(difference, parse_decimal("5e-10")), 0);
}

TEST(RootNumber, SeventeenDigitsOfADoubleAreItsShortestOrLonger) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int i = 0; i < 2000; ++i) {
    const double x = std::pow(10.0, exponent(random));
    EXPECT_EQ(std::stod(decimal_text(RootNumber{exact(x)}, 17)), x) << fmt::format("{:a}, seed 11", x);
  }
}

TEST(RootNumber, TextIsTheNumberItself) {
  EXPECT_EQ(exact_text(RootNumber{Rational(3, 4)}), "3/4");
  EXPECT_EQ(exact_text(RootNumber{Rational(1, 2), Rational(9, 4), -1}), "-1");
  EXPECT_EQ(exact_text(RootNumber{0, Rational(2)}), "sqrt(2)");
  EXPECT_EQ(exact_text(RootNumber{Rational(1, 2), Rational(1, 3), -1}), "1/2 - sqrt(1/3)");
}

}  // namespace
}  // namespace axiscert
