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
    const Rational computed[2] = {Rational(computed_lhs), Rational(computed_rhs)};
    const mpz_class unit = common_denominator({&computed[0], &computed[1], &lhs, &rhs});
    const mpz_class left = in_units(lhs, unit), right = in_units(rhs, unit);
    difference_ = in_units(computed[0], unit) - in_units(computed[1], unit);
    difference_ -= left;
    difference_ += right;
    if (sgn(difference_) == 0) return;
    difference_ = abs(difference_);
    scale_ = abs(left) + abs(right);
    if (sgn(scale_) == 0) kind_ = Kind::without_scale;
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
