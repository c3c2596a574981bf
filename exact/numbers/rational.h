// Exact rationals, and the floats nearest to them. Every rounding here is correct, subnormals included.
#pragma once

#include <gmpxx.h>

#include <optional>
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

}  // namespace axiscert
