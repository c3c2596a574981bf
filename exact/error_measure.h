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
  bool is_zero() const { return mantissa == 0; }
  double value() const;            // the double nearest to the decimal; its shortest text is the decimal again
};

// The least Decimal6 that is not below q >= 0.
Decimal6 round_up(const Rational& q);

// The error of one comparison, in units of u: |(l^ - r^) - (l - r)| / (u (|l| + |r|)), where l^, r^ are the computed
// sides, subtracted exactly, l, r the exact ones, and u = 2^-24 or 2^-53. 0/0 is 0.
class ComparisonError {
 public:
  enum class Kind : std::uint8_t {
    finite,
    without_scale,  // a non-zero difference over |l| + |r| = 0
    range_event,    // a computed side is not finite
  };

  // `Real` is the precision that lhs and rhs were computed in; it fixes u.
  template <class Real>
  ComparisonError(Real computed_lhs, Real computed_rhs, const Ring& exact_lhs, const Ring& exact_rhs);

  Kind kind() const { return kind_; }
  // Bounds of the error, for selecting candidates only; lower <= error <= upper, certain.
  double lower() const { return lower_; }
  double upper() const { return upper_; }
  // The error itself. Only for Kind::finite.
  Rational exact() const;
  bool exceeds(const Rational& tolerance) const;

 private:
  Kind kind_ = Kind::finite;
  int digits_;
  Ring difference_, scale_;
  double lower_ = 0, upper_ = 0;
};

}  // namespace axiscert
