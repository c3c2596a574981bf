// The error of one computed comparison whose exact sides are rational: |(l^ - r^) - (l - r)| / (u (|l| + |r|)), as
// exact/sphere_triangle/measures/error_measure.h defines it, with u = 2^-24 or 2^-53 and 0/0 as 0.
#pragma once

#include <cmath>
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
  SideError(Real computed_lhs, Real computed_rhs, const Rational& lhs, const Rational& rhs) {
    if (!std::isfinite(computed_lhs) || !std::isfinite(computed_rhs)) {
      kind_ = Kind::range_event;
      return;
    }
    const Rational difference = abs(Rational(Rational(computed_lhs) - Rational(computed_rhs) - Rational(lhs - rhs)));
    if (sgn(difference) == 0) return;
    const Rational scale = abs(lhs) + abs(rhs);
    if (sgn(scale) == 0) {
      kind_ = Kind::without_scale;
      return;
    }
    error_ = difference / scale;
    mpq_mul_2exp(error_.get_mpq_t(), error_.get_mpq_t(), std::numeric_limits<Real>::digits);
  }

  Kind kind() const { return kind_; }
  // No less than the error, for selecting candidates. For Kind::finite alone.
  double upper() const {
    if (sgn(error_) == 0) return 0;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return std::nextafter(error_.get_d() * (1 + 0x1p-40), infinity);  // get_d() truncates
  }
  Decimal6 rounded_up() const { return round_up(error_); }
  bool exceeds(const Rational& tolerance) const { return error_ > tolerance; }

 private:
  Kind kind_ = Kind::finite;
  Rational error_;
};

}  // namespace axiscert
