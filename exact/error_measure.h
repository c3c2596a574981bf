// The error of a computed comparison, and its exact, stored form.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include "exact/formula_oracle.h"

namespace axiscert {

// Six significant digits: mantissa * 10^exponent with mantissa in [100000, 999999], or zero. Ordered by value.
struct Decimal6 {
  std::int32_t exponent = INT32_MIN;
  std::uint32_t mantissa = 0;
  auto operator<=>(const Decimal6&) const = default;
  // Rounding up to six digits raises a number by less than a part in 10^5: one that is less than this times another
  // comes to no greater a decimal, and to no equal one.
  static constexpr double least_ratio = 1 - 1.1e-5;
  bool is_zero() const { return mantissa == 0; }
  // The double nearest to the decimal, whose shortest text is the decimal again; infinite beyond binary64's range,
  // where errors do get: against an exact side of 2^-2148 the least rounding is enough.
  double value() const;
  std::string text() const;  // "366.123", "1.5e+620": as a double is written, at any size
};

// A quotient of non-negative integers, not reduced.
struct Fraction {
  mpz_class numerator, denominator;
};

// The least Decimal6 that is not below q >= 0.
Decimal6 round_up(const Fraction& q);
inline Decimal6 round_up(const Rational& q) { return round_up(Fraction{q.get_num(), q.get_den()}); }

// The error of one comparison, in units of u: |(l^ - r^) - (l - r)| / (u (|l| + |r|)), where l^, r^ are the computed
// sides, subtracted exactly, l, r the exact ones, and u = 2^-24 or 2^-53. 0/0 is 0.
class ComparisonError {
 public:
  enum class Kind : std::uint8_t {
    finite,
    without_scale,  // a non-zero difference over |l| + |r| = 0, or sides that exact arithmetic does not define
    range_event,    // a computed side is not finite
  };

  // `Real` is the precision that lhs and rhs were computed in; it fixes u.
  template <class Real>
  ComparisonError(Real computed_lhs, Real computed_rhs, const ExactComparison& exact);

  Kind kind() const { return kind_; }
  // Bounds of the error, for selecting candidates only; lower <= error <= upper, certain.
  double lower() const { return lower_; }
  double upper() const { return upper_; }
  // The error itself, rounded up. Only for Kind::finite.
  Decimal6 rounded_up() const;
  // Not rounded. Only for Kind::finite where no side is a root.
  Fraction exact() const;
  bool exceeds(const Rational& tolerance) const;

 private:
  bool exactly_exceeds(const Rational& tolerance) const;

  Kind kind_ = Kind::finite;
  int digits_;
  // Without a root: |(l^ - r^) - (l - r)| and |l| + |r|, times the sides' denominator. With one, lhs = sqrt(s): the
  // difference is |offset - sqrt(s)|, the scale sqrt(s) + |r|, times the same.
  bool rooted_ = false;
  Ring difference_, scale_;
  Ring offset_, square_, rhs_;
  double lower_ = 0, upper_ = 0;
};

}  // namespace axiscert
