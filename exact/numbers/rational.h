// Exact rationals, and the floats nearest to them. Every rounding here is correct, subnormals included.
#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace axiscert {
using Rational = mpq_class;

// A finite float as a dyadic rational, exactly.
Rational exact(double value);

// A decimal such as "12.5", "-3" or "1e-3" as a rational, exactly. Throws Error.
Rational parse_decimal(std::string_view text);

// The Real nearest to q, ties to even; overflows to infinity as IEEE rounding does.
template <class Real>
Real nearest(const Rational& q);

// The Real nearest to sqrt(numerator / denominator), both >= 0, denominator > 0. Rounded once.
template <class Real>
Real nearest_sqrt(const mpz_class& numerator, const mpz_class& denominator);
template <class Real>
Real nearest_sqrt(const Rational& q) {
  return nearest_sqrt<Real>(q.get_num(), q.get_den());
}
// The least Real that is not below sqrt(q), q >= 0; empty beyond the greatest.
template <class Real>
std::optional<Real> sqrt_rounded_up(const Rational& q);

// Six significant decimal digits, rounded up once: the stored form of an error.

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

// x 2^exponent.
inline Rational times_power(const Rational& x, int exponent) {
  Rational result;
  if (exponent >= 0) mpq_mul_2exp(result.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(result.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

}  // namespace axiscert
