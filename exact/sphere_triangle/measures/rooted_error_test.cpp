// Errors of computed sides if an exact side is a root, compared with an evaluation at 2000 bits.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <random>

#include "exact/judge/side_error.h"
#include "exact/numbers/mpfr_number.h"

namespace axiscert {
namespace {

// The error of computed sides against sqrt(s) / d and r / d.
template <class Real>
SideError rooted_error(Real computed_lhs, Real computed_rhs, const BinaryNumber& s, const BinaryNumber& r,
                       const BinaryNumber& d) {
  return {computed_lhs, computed_rhs, {BinaryFraction(s, d), BinaryFraction(r, d), true}};
}

TEST(RootedError, HandValues) {
  using Kind = SideError::Kind;
  const auto of = [](float l, float r, int square, int rhs, int denominator) {
    return rooted_error(l, r, BinaryNumber(square), BinaryNumber(rhs), BinaryNumber(denominator));
  };
  EXPECT_EQ(of(2, 1, 4, 1, 1).rounded_up(), Decimal6()) << "sqrt(4) = 2";
  EXPECT_EQ(of(3, 1, 4, 1, 1).rounded_up(), round_up(Rational(1 << 24, 3)));
  EXPECT_EQ(of(1, 1, 4, 1, 1).rounded_up(), round_up(Rational(1 << 24, 3)));
  EXPECT_EQ(of(1, 0.5f, 4, 1, 2).rounded_up(), Decimal6()) << "sqrt(4) / 2, 1 / 2";
  EXPECT_EQ(of(-2, 0, 4, 0, 1).rounded_up(), round_up(Rational(2 << 24)));
  EXPECT_EQ(of(0, 0, 0, 0, 1).rounded_up(), Decimal6());
  EXPECT_EQ(of(1, 0, 0, 0, 1).kind(), Kind::without_scale);
  EXPECT_EQ(of(-1, 0, 0, 0, 1).kind(), Kind::without_scale);
  EXPECT_EQ(of(INFINITY, 0, 4, 1, 1).kind(), Kind::range_event);
  EXPECT_TRUE(of(3, 1, 4, 1, 1).exceeds(Rational(1 << 24, 3) - Rational(1, 1000)));
  EXPECT_FALSE(of(3, 1, 4, 1, 1).exceeds(Rational(1 << 24, 3)));
}

TEST(RootedError, UndefinedSidesHaveNoScale) {
  const BinaryFraction none(0.0);
  const SideError error(NAN, 1.f, ExactComparison{none, none, false, true});
  EXPECT_EQ(error.kind(), SideError::Kind::without_scale);
}

Rational decimal(std::uint32_t mantissa, int exponent) {
  return parse_decimal(std::to_string(mantissa) + "e" + std::to_string(exponent));
}

template <class Real>
void expect_errors_as_at_2000_bits(int greatest_exponent) {
  constexpr int seed = 64;
  std::mt19937_64 random(seed);
  int measured = 0;
  for (int i = 0; i < 1500; ++i) {
    const int exponent = static_cast<int>(random() % (2 * greatest_exponent + 1)) - greatest_exponent;
    const auto number = [&](int e) { return std::ldexp(static_cast<double>(random() >> 11) + 1, e - 52); };
    const double s = number(2 * exponent), r = random() % 4 == 0 ? 0 : number(exponent), d = number(0);
    // Near the exact sides, or far from them, or with the wrong sign.
    const auto off = [&] { return static_cast<double>(random() % 9) - 4; };
    const Real epsilon = std::numeric_limits<Real>::epsilon();
    Real lhs = static_cast<Real>(std::sqrt(s) / d), rhs = static_cast<Real>(r / d);
    lhs *= random() % 8 == 0 ? static_cast<Real>(off()) : static_cast<Real>(1 + off() * epsilon);
    if (!std::isfinite(lhs) || !std::isfinite(rhs)) continue;
    const SideError error = rooted_error(lhs, rhs, BinaryNumber(s), BinaryNumber(r), BinaryNumber(d));
    ASSERT_EQ(error.kind(), SideError::Kind::finite);

    const Mpfr<2000> root = square_root(Mpfr<2000>(s)), exact_rhs(r), by(d);
    const Mpfr<2000> difference = (Mpfr<2000>(lhs) - Mpfr<2000>(rhs)) * by - (root - exact_rhs);
    const Mpfr<2000> reference =
        magnitude(difference) / (root + exact_rhs) * Mpfr<2000>(std::ldexp(1, std::numeric_limits<Real>::digits));
    const auto above = [&](const Rational& q) { return mpfr_cmp_q(reference.get(), q.get_mpq_t()) > 0; };
    const std::string what = "case " + std::to_string(i) + " of seed " + std::to_string(seed);
    EXPECT_GE(order(reference, Mpfr<2000>(error.lower())), 0) << what;
    EXPECT_LE(order(reference, Mpfr<2000>(error.upper())), 0) << what;
    if (order(reference, Mpfr<2000>(0)) == 0) continue;
    ++measured;
    const Decimal6 up = error.rounded_up();
    EXPECT_FALSE(above(decimal(up.mantissa, up.exponent))) << what;
    EXPECT_TRUE(above(decimal(up.mantissa - 1, up.exponent))) << what;
    EXPECT_GE(up.mantissa, 100000u) << what;
    // Tolerances one part in 2^600 around the error: only exact arithmetic distinguishes them.
    Rational near;
    mpfr_get_q(near.get_mpq_t(), reference.get());
    const Rational step = near / Rational(mpz_class(1) << 600);
    EXPECT_FALSE(error.exceeds(near + step)) << what;
    EXPECT_TRUE(error.exceeds(near - step)) << what;
  }
  EXPECT_GT(measured, 1000);
}
TEST(RootedError, IsThatOf2000BitsInBinary32) { expect_errors_as_at_2000_bits<float>(60); }
TEST(RootedError, IsThatOf2000BitsInBinary64) { expect_errors_as_at_2000_bits<double>(500); }

}  // namespace
}  // namespace axiscert
