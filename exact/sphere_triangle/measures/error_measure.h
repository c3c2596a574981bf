// The error of a computed comparison.
#pragma once

#include "exact/numbers/decimal6.h"
#include "exact/sphere_triangle/oracles/formula_oracle.h"

namespace axiscert {

// The error of one comparison, in units of u: |(l^ - r^) - (l - r)| / (u (|l| + |r|)), where l^, r^ are the computed
// sides, subtracted exactly, l, r the exact ones, and u = 2^-24 or 2^-53. 0/0 counts as 0.
class ComparisonError {
 public:
  enum class Kind : std::uint8_t {
    finite,
    without_scale,  // a non-zero difference over |l| + |r| = 0, or sides that exact arithmetic does not define
    range_event,    // a computed side is not finite
  };

  // `Real` is the precision in which lhs and rhs were computed; it determines u.
  template <class Real>
  ComparisonError(Real computed_lhs, Real computed_rhs, const ExactComparison& exact);

  Kind kind() const { return kind_; }
  // Certain bounds, lower <= error <= upper, for selecting candidates only.
  double lower() const { return lower_; }
  double upper() const { return upper_; }
  // The error itself, rounded up. Only valid for Kind::finite.
  Decimal6 rounded_up() const;
  // The error before rounding. Only valid for Kind::finite if no side is a root.
  Fraction exact() const;
  bool exceeds(const Rational& tolerance) const;

 private:
  bool exactly_exceeds(const Rational& tolerance) const;

  Kind kind_ = Kind::finite;
  int digits_;
  // Without a root: |(l^ - r^) - (l - r)| and |l| + |r|, times the sides' denominator. With a root, lhs = sqrt(s): the
  // difference is |offset - sqrt(s)| and the scale sqrt(s) + |r|, times the same denominator.
  bool rooted_ = false;
  Ring difference_, scale_;
  Ring offset_, square_, rhs_;
  double lower_ = 0, upper_ = 0;
};

}  // namespace axiscert
