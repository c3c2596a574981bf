// Errors, depths, critical radii and roundings, compared with values computed by hand and with MPFR at high precision.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <bit>
#include <cmath>
#include <random>

#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/judge/side_error.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/forms/scalar.h"

namespace axiscert {
namespace {

Rational rational_of(const Fraction& f) {
  Rational q(f.numerator, f.denominator);
  q.canonicalize();
  return q;
}

TEST(RoundUp, KeepsSixDigitsAndNeverRoundsDown) {
  EXPECT_EQ(round_up(Rational(0)), Decimal6());
  EXPECT_EQ(round_up(Rational(1)).value(), 1.0);
  EXPECT_EQ(round_up(Rational(1, 3)).value(), 0.333334);
  EXPECT_EQ(round_up(Rational(2, 3)).value(), 0.666667);
  EXPECT_EQ(round_up(Rational(9999991, 10)).value(), 1000000.0) << "the carry makes a seventh digit";
  EXPECT_EQ(round_up(Rational(123456)).value(), 123456.0);
  EXPECT_EQ(round_up(parse_decimal("1e-300")).value(), 1e-300);
  EXPECT_LT(round_up(Rational(1, 3)), round_up(Rational(1, 2)));
  EXPECT_LT(Decimal6(), round_up(parse_decimal("1e-30")));
  EXPECT_EQ(round_up(Rational(1, 3)).text(), "0.333334");
  EXPECT_EQ(round_up(parse_decimal("1.25e620")).text(), "1.25e+620") << "beyond binary64";
  EXPECT_EQ(round_up(parse_decimal("1e620")).text(), "1e+620");
  EXPECT_THROW(parse_decimal("1e-2147483648"), Error);
}

TEST(RoundUp, IsTheLeastDecimalThatIsNotBelow) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 2000; ++i) {
    const Rational q = exact(std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 120) - 90));
    const Decimal6 up = round_up(q);
    const auto decimal = [](std::uint32_t m, int e) {
      return parse_decimal(std::to_string(m) + "e" + std::to_string(e));
    };
    EXPECT_GE(decimal(up.mantissa, up.exponent), q);
    EXPECT_LT(decimal(up.mantissa - 1, up.exponent), q);
    EXPECT_GE(up.mantissa, 100000u);
  }
}

// |(l^ - r^) - (l - r)| / (u (|l| + |r|)), with u = 2^-24.
template <class Real>
SideError error_of(Real computed_lhs, Real computed_rhs, const BinaryNumber& lhs, const BinaryNumber& rhs) {
  return {computed_lhs, computed_rhs, {BinaryFraction(lhs), BinaryFraction(rhs)}};
}

TEST(ComparisonErrorTest, HandValues) {
  using Kind = SideError::Kind;
  const SideError exact_one = error_of(3.f, 1.f, BinaryNumber(3), BinaryNumber(1));
  EXPECT_EQ(exact_one.kind(), Kind::finite);
  EXPECT_EQ(rational_of(exact_one.exact()), 0);
  EXPECT_EQ(rational_of(error_of(3.f, 1.f, BinaryNumber(2), BinaryNumber(1)).exact()), Rational(1 << 24) / 3);
  EXPECT_EQ(rational_of(error_of(3.0, 1.0, BinaryNumber(2), BinaryNumber(-2)).exact()),
            Rational(mpz_class(1) << 53) * 2 / 4);
  EXPECT_EQ(rational_of(error_of(0.f, 0.f, BinaryNumber(), BinaryNumber()).exact()), 0);
  EXPECT_EQ(error_of(1.f, 0.f, BinaryNumber(), BinaryNumber()).kind(), Kind::without_scale);
  EXPECT_EQ(error_of(INFINITY, 0.f, BinaryNumber(1), BinaryNumber()).kind(), Kind::range_event);
  EXPECT_EQ(error_of(0.f, NAN, BinaryNumber(1), BinaryNumber()).kind(), Kind::range_event);
}

TEST(ComparisonErrorTest, BoundsEncloseTheExactErrorAndToleranceIsExact) {
  std::mt19937_64 random(12);
  for (int i = 0; i < 2000; ++i) {
    const auto wide = [&] {
      return std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 900) - 500);
    };
    const double l = wide(), r = wide();
    const SideError error = error_of(static_cast<double>(static_cast<float>(l)), r, BinaryNumber(l), BinaryNumber(r));
    if (error.kind() != SideError::Kind::finite) continue;
    const Rational exactly = rational_of(error.exact());
    EXPECT_LE(exact(error.lower()), exactly);
    if (std::isfinite(error.upper())) {
      EXPECT_GE(exact(error.upper()), exactly);
    }
    EXPECT_FALSE(error.exceeds(exactly));
    if (sgn(exactly) > 0) {
      EXPECT_TRUE(error.exceeds(exactly * (1 - Rational(1, mpz_class(1) << 200))));
    }
  }
}

TEST(ParseDecimal, IsExactAndRefusesAnythingElse) {
  EXPECT_EQ(parse_decimal("12.5"), Rational(25, 2));
  EXPECT_EQ(parse_decimal("0.1"), Rational(1, 10));
  EXPECT_EQ(parse_decimal("-1.25e-1"), Rational(-1, 8));
  EXPECT_EQ(parse_decimal("3e+2"), 300);
  for (const char* bad : {"", "-", "1.2.3", "e5", "1e", "0x1p3", "nan", "1 ", "1e99999", "1e+-5"}) {
    EXPECT_THROW(parse_decimal(bad), Error) << bad;
  }
}

template <class Real>
void expect_nearest_roots() {
  std::mt19937_64 random(13);
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  for (int i = 0; i < 3000; ++i) {
    Real x;
    do x = std::abs(std::bit_cast<Real>(static_cast<Bits>(random())));
    while (!std::isfinite(x));
    const Rational q = exact(x);
    EXPECT_EQ(nearest<Real>(q), x);
    EXPECT_EQ(nearest_sqrt<Real>(q * q), x) << "a root that is a float, subnormals included";
    EXPECT_EQ(nearest_sqrt<Real>(q), std::sqrt(x)) << "IEEE's square root is correctly rounded";
    // Just above and just below a midpoint: the two neighbours; on it: the even one.
    const Real up = std::nextafter(x, std::numeric_limits<Real>::infinity());
    if (!std::isfinite(up)) continue;
    const Rational middle = (q + exact(up)) / 2, off = Rational(1, mpz_class(1) << 5000);
    EXPECT_EQ(nearest_sqrt<Real>(middle * middle + off), up);
    EXPECT_EQ(nearest_sqrt<Real>(middle * middle - off), x);
    const Real even = (std::bit_cast<Bits>(x) & 1) == 0 ? x : up;
    EXPECT_EQ(nearest_sqrt<Real>(middle * middle), even);
  }
}
TEST(NearestSqrt, Binary32) { expect_nearest_roots<float>(); }
TEST(NearestSqrt, Binary64) { expect_nearest_roots<double>(); }

TEST(Depth, IsRoundedOnceFromTheExactValue) {
  std::mt19937_64 random(14);
  for (int i = 0; i < 500; ++i) {
    std::array<double, coordinate_count> v;
    for (double& x : v) x = static_cast<double>(static_cast<std::int64_t>(random()) >> 11);
    v[12] = std::abs(v[12]);
    const auto q = from_coordinates(v);
    const Rational dd = squared_distance(q);
    // The same quantity at 3000 bits, with roundings that enclose it; both ends round to the same double.
    mpfr_t d, s, t;
    mpfr_inits2(3000, d, s, t, nullptr);
    mpfr_set_q(d, dd.get_mpq_t(), MPFR_RNDN);
    mpfr_sqrt(d, d, MPFR_RNDN);
    mpfr_sub_d(d, d, v[12], MPFR_RNDN);
    mpfr_abs(d, d, MPFR_RNDN);
    mpfr_set_d(s, v[12], MPFR_RNDN);
    for (int k = 0; k < 3; ++k) {
      const Rational x = exact(v[3 * k]) - exact(v[9]), y = exact(v[3 * k + 1]) - exact(v[10]),
                     z = exact(v[3 * k + 2]) - exact(v[11]);
      mpfr_set_q(t, Rational(x * x + y * y + z * z).get_mpq_t(), MPFR_RNDN);
      mpfr_sqrt(t, t, MPFR_RNDN);
      mpfr_max(s, s, t, MPFR_RNDN);
    }
    mpfr_div(d, d, s, MPFR_RNDN);
    EXPECT_EQ(depth(q, dd), mpfr_get_d(d, MPFR_RNDN)) << "case " << i << " of seed 14";
    mpfr_clears(d, s, t, nullptr);
  }
}

// Rational depths that lie exactly between two doubles are rounded to the even one; no finite precision would decide
// them.
TEST(Depth, TiesGoToEven) {
  const double big = 0x1p53;
  // d = 2^53 + 1 (a vertex of a triangle on the axis), r = 0, greatest length 2^54: the quotient is a midpoint.
  const Query<double> q{{big, 0, 0}, {2 * big, 0, 0}, {2 * big, 0, 0}, {-1, 0, 0}, 0};
  const Rational d = exact(big) + 1;
  const double found = depth(q, d * d);
  const Rational exactly = d / (2 * exact(big) + 1);
  EXPECT_EQ(found, nearest<double>(exactly));
  EXPECT_EQ(depth(Query<double>{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0}, 0), 0) << "no scene, no depth";
}

// For a vertex at distance 2 the published test changes its answer at r = 2 exactly; at sqrt(3) one ulp below.
TEST(CriticalRadius, IsMeasuredInUlpsOfTheExactDistance) {
  const auto kernel = find_kernel("published").on<float>(scalar_target);
  EXPECT_EQ(critical_radius_error<float>(kernel, {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}, {0, 0, 0}, 9}, 4).ulps, 0);
  EXPECT_EQ(critical_radius_error<float>(kernel, {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {0, 0, 0}, 9}, 3).ulps, 0);
  const auto never = [](const QueryColumns<float>& batch, Verdict* out) {
    std::fill_n(out, batch.size, Verdict::separated);
  };
  EXPECT_EQ(critical_radius_error<float>({never, nullptr}, {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}, {0, 0, 0}, 9}, 4).ulps,
            INFINITY);
}

TEST(CriticalRadius, EndsOfTheRange) {
  const auto kernel = find_kernel("published").on<float>(scalar_target);
  const float max = std::numeric_limits<float>::max();
  const Query<float> beyond{{max, max, 0}, {max, max, 1}, {max, max, 2}, {-max, -max, 0}, 0};
  EXPECT_FALSE(critical_radius_error<float>(kernel, beyond, squared_distance(beyond)).ulps);
  const Query<float> at_max{{max, 0, 0}, {max, 1, 0}, {max, 0, 1}, {0, 0, 0}, 0};
  EXPECT_TRUE(critical_radius_error<float>(kernel, at_max, squared_distance(at_max)).ulps);
  const Query<float> at_zero{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, 0};
  EXPECT_EQ(critical_radius_error<float>(kernel, at_zero, 0).ulps, 0);
}

}  // namespace
}  // namespace axiscert
