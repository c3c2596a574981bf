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
  // Rounding up to six digits raises a number by less than a part in 10^5: one that is less than this times another
  // comes to no greater a decimal, and to no equal one.
  static constexpr double least_ratio = 1 - 1.1e-5;
  bool is_zero() const { return mantissa == 0; }
  // The double nearest to the decimal, whose shortest text is the decimal again; infinite beyond binary64's range,
  // where errors do get: against an exact side of 2^-2148 the least rounding is enough.
  double value() const;
  std::string text() const;  // "366.123", "1.5e+620": as a double is written, at any size
};

// The number that it is, and its neighbours; not for zero.
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
