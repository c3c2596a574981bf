// The error of one computed comparison whose exact sides are rational: |(l^ - r^) - (l - r)| / (u (|l| + |r|)), as
// exact/sphere_triangle/measures/error_measure.h defines it, with u = 2^-24 or 2^-53 and 0/0 as 0.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "exact/numbers/binary_fraction.h"
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
  SideError(Real computed_lhs, Real computed_rhs, const BinaryFraction& lhs, const BinaryFraction& rhs)
      : digits_(std::numeric_limits<Real>::digits) {
    if (!std::isfinite(computed_lhs) || !std::isfinite(computed_rhs)) {
      kind_ = Kind::range_event;
      return;
    }
    // All in one unit, which the error does not depend on.
    const BinaryNumber computed = BinaryNumber(computed_lhs) - BinaryNumber(computed_rhs);
    if (lhs.under == rhs.under) take(computed * lhs.under, lhs.over, rhs.over);
    else take(computed * (lhs.under * rhs.under), lhs.over * rhs.under, rhs.over * lhs.under);
  }

  Kind kind() const { return kind_; }
  // No less than the error, for selecting candidates. For Kind::finite alone.
  double upper() const {
    if (difference_.sign() == 0) return 0;
    // Both mantissas are truncated, which moves the quotient by less than 2^-51 of itself, as its rounding does.
    const auto [above, over] = leading(difference_);
    const auto [below, under] = leading(scale_);
    constexpr long least = -2000, greatest = 2000;  // beyond all exponents of double
    const int exponent = static_cast<int>(std::clamp(above - below + digits_, least, greatest));
    return std::nextafter(std::ldexp(over / under * (1 + 0x1p-40), exponent), std::numeric_limits<double>::infinity());
  }
  Decimal6 rounded_up() const { return round_up(difference_.sign() == 0 ? Rational(0) : in_u()); }
  bool exceeds(const Rational& tolerance) const { return difference_.sign() != 0 && in_u() > tolerance; }

 private:
  // l^ - r^, l and r.
  void take(const BinaryNumber& computed, const BinaryNumber& left, const BinaryNumber& right) {
    difference_ = magnitude(computed - (left - right));
    if (difference_.sign() == 0) return;
    scale_ = magnitude(left) + magnitude(right);
    if (scale_.sign() == 0) kind_ = Kind::without_scale;
  }
  // Exponent and mantissa, truncated, in [0.5, 1).
  static std::pair<long, double> leading(const BinaryNumber& x) {
    return x.as_mpz([](mpz_srcptr whole, long exponent) {
      long more = 0;
      const double mantissa = mpz_get_d_2exp(&more, whole);
      return std::pair(exponent + more, mantissa);
    });
  }
  Rational in_u() const {
    Rational error = rational(difference_) / rational(scale_);
    mpq_mul_2exp(error.get_mpq_t(), error.get_mpq_t(), static_cast<mp_bitcnt_t>(digits_));
    return error;
  }

  Kind kind_ = Kind::finite;
  int digits_;
  BinaryNumber difference_, scale_;  // |l^ - r^ - (l - r)| and |l| + |r|, in one unit
};

// No less than the error, from the leading words alone: infinite where these do not tell, as where it is of another
// kind than `finite`.
template <class Real>
double side_error_at_most(Real computed_lhs, Real computed_rhs, const BinaryFraction& lhs, const BinaryFraction& rhs) {
  using Long = long double;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (!lhs.is_whole() || !rhs.is_whole()) return unknown;
  // All that is rounded, and what the leading words leave out, is less than this part of the four numbers: a few
  // roundings, and 2^-63 of an exact side.
  constexpr Long lost = std::max(16 * std::numeric_limits<Long>::epsilon(), Long(0x1p-59));
  const Long left = lhs.over.approximately(), right = rhs.over.approximately();
  const Long scale = std::fabs(left) + std::fabs(right);
  const Long computed = static_cast<Long>(computed_lhs) - static_cast<Long>(computed_rhs);
  const Long sizes = std::fabs(static_cast<Long>(computed_lhs)) + std::fabs(static_cast<Long>(computed_rhs)) + scale;
  const Long error = (std::fabs(computed - (left - right)) + lost * sizes) / scale;
  const bool is_known = scale > std::numeric_limits<Long>::min() / lost && error < std::numeric_limits<float>::max();
  constexpr Long one_u = Long(1) * (std::uint64_t{1} << std::numeric_limits<Real>::digits);
  return is_known ? static_cast<double>(error * one_u * (1 + 0x1p-40L)) : unknown;
}

}  // namespace axiscert
