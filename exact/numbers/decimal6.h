// Six significant decimal digits, rounded up once: the stored form of an error.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include "exact/numbers/rational.h"

namespace axiscert {

// Six significant digits: mantissa * 10^exponent with mantissa in [100000, 999999], or zero. Ordered by value.
struct Decimal6 {
  std::int32_t exponent = INT32_MIN;
  std::uint32_t mantissa = 0;
  auto operator<=>(const Decimal6&) const = default;
  // Rounding up to six digits increases a number by less than one part in 10^5: a number below this ratio times another
  // rounds to a strictly smaller decimal.
  static constexpr double least_ratio = 1 - 1.1e-5;
  bool is_zero() const { return mantissa == 0; }
  // The double nearest to the decimal; its shortest text is the decimal again. Infinite beyond binary64's range, which
  // errors do reach: against an exact side of 2^-2148 the least rounding is enough.
  double value() const;
  std::string text() const;  // "366.123", "1.5e+620": in the format of a double, at any size
};

// The decimal's exact value, and its two neighbours among the decimals; the neighbours are not defined for zero.
Rational exact(const Decimal6& d);
Decimal6 next(Decimal6 d);
Decimal6 previous(Decimal6 d);

// A quotient of non-negative integers, not reduced.
struct Fraction {
  mpz_class numerator, denominator;
};

// The least Decimal6 that is not below q >= 0.
Decimal6 round_up(const Fraction& q);
inline Decimal6 round_up(const Rational& q) { return round_up(Fraction{q.get_num(), q.get_den()}); }

}  // namespace axiscert
