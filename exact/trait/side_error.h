// The error of one computed comparison whose exact sides are rational: |(l^ - r^) - (l - r)| / (u (|l| + |r|)), as
// exact/sphere_triangle/measures/error_measure.h defines it, with u = 2^-24 or 2^-53 and 0/0 as 0.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "exact/numbers/decimal6.h"

namespace axiscert {

class SideError {
 public:
  enum class Kind : std::uint8_t {
    finite,
    without_scale,  // a non-zero difference over |l| + |r| = 0
    range_event,    // a computed side is not finite
  };

  // `Real` is the precision in which the sides were computed.
  template <class Real>
  SideError(Real computed_lhs, Real computed_rhs, const Rational& lhs, const Rational& rhs)
      : digits_(std::numeric_limits<Real>::digits) {
    if (!std::isfinite(computed_lhs) || !std::isfinite(computed_rhs)) {
      kind_ = Kind::range_event;
      return;
    }
    // All four in one unit, which the error does not depend on: integers need no greatest common divisors.
    if (is_power_of_two(lhs.get_den_mpz_t()) && is_power_of_two(rhs.get_den_mpz_t())) {
      const Shifted sides[2] = {lhs, rhs}, computed[2] = {computed_lhs, computed_rhs};
      const long unit = std::min({sides[0].exponent, sides[1].exponent, computed[0].exponent, computed[1].exponent});
      take(sides[0].in_units(unit), sides[1].in_units(unit), computed[0].in_units(unit), computed[1].in_units(unit));
    } else {
      const Rational computed[2] = {Rational(computed_lhs), Rational(computed_rhs)};
      const mpz_class unit = common_denominator({&computed[0], &computed[1], &lhs, &rhs});
      take(in_units(lhs, unit), in_units(rhs, unit), in_units(computed[0], unit), in_units(computed[1], unit));
    }
  }

  Kind kind() const { return kind_; }
  // No less than the error, for selecting candidates. For Kind::finite alone.
  double upper() const {
    if (sgn(difference_) == 0) return 0;
    // Both mantissas are truncated, which moves the quotient by less than 2^-51 of itself, as its rounding does.
    long above = 0, below = 0;
    const double mantissa =
        mpz_get_d_2exp(&above, difference_.get_mpz_t()) / mpz_get_d_2exp(&below, scale_.get_mpz_t());
    constexpr long least = -2000, greatest = 2000;  // beyond all exponents of double
    const int exponent = static_cast<int>(std::clamp(above - below + digits_, least, greatest));
    return std::nextafter(std::ldexp(mantissa * (1 + 0x1p-40), exponent), std::numeric_limits<double>::infinity());
  }
  Decimal6 rounded_up() const { return round_up(sgn(difference_) == 0 ? Rational(0) : in_u()); }
  bool exceeds(const Rational& tolerance) const { return sgn(difference_) != 0 && in_u() > tolerance; }

 private:
  // whole 2^exponent, of a float or of a rational whose denominator is a power of two.
  struct Shifted {
    Shifted(const Rational& x) : whole(x.get_num()), exponent(-static_cast<long>(mpz_scan1(x.get_den_mpz_t(), 0))) {}
    Shifted(double x) {
      int above = 0;
      constexpr int digits = std::numeric_limits<double>::digits;
      whole = std::ldexp(std::frexp(x, &above), digits);
      exponent = x == 0 ? 0 : above - digits;
    }
    // `unit` is not above the exponent.
    mpz_class in_units(long unit) const {
      mpz_class units;
      mpz_mul_2exp(units.get_mpz_t(), whole.get_mpz_t(), static_cast<mp_bitcnt_t>(exponent - unit));
      return units;
    }
    mpz_class whole;
    long exponent;
  };
  static bool is_power_of_two(mpz_srcptr x) { return mpz_popcount(x) == 1; }

  // All in one unit.
  void take(const mpz_class& left, const mpz_class& right, const mpz_class& computed_left,
            const mpz_class& computed_right) {
    difference_ = computed_left - computed_right;
    difference_ -= left;
    difference_ += right;
    if (sgn(difference_) == 0) return;
    difference_ = abs(difference_);
    scale_ = abs(left) + abs(right);
    if (sgn(scale_) == 0) kind_ = Kind::without_scale;
  }

  static mpz_class common_denominator(std::initializer_list<const Rational*> numbers) {
    mpz_class common = 1;
    for (const Rational* x : numbers) {
      const mpz_srcptr denominator = x->get_den_mpz_t();
      // Powers of two, which denominators of floats are, divide each other.
      if (mpz_divisible_p(common.get_mpz_t(), denominator)) continue;
      if (mpz_divisible_p(denominator, common.get_mpz_t())) common = x->get_den();
      else mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), denominator);
    }
    return common;
  }
  static mpz_class in_units(const Rational& x, const mpz_class& unit) {
    mpz_class factor;
    mpz_divexact(factor.get_mpz_t(), unit.get_mpz_t(), x.get_den_mpz_t());
    return x.get_num() * factor;
  }
  Rational in_u() const {
    Rational error(difference_, scale_);
    error.canonicalize();
    mpq_mul_2exp(error.get_mpq_t(), error.get_mpq_t(), static_cast<mp_bitcnt_t>(digits_));
    return error;
  }

  Kind kind_ = Kind::finite;
  int digits_;
  mpz_class difference_, scale_;  // |l^ - r^ - (l - r)| and |l| + |r|, in one unit
};

}  // namespace axiscert
