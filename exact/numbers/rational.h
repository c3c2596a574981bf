// Exact rationals, and the floats nearest to them. Every rounding here is correct, subnormals included.
#pragma once

#include <gmpxx.h>

#include <string_view>

namespace axiscert {

using Rational = mpq_class;

// A finite float as the dyadic rational that it is.
Rational exact(double value);

// A decimal such as "12.5", "-3" or "1e-3" as the rational that it is. Throws Error.
Rational parse_decimal(std::string_view text);

// The Real nearest to q, ties to even; rounds to infinity where a Real would.
template <class Real>
Real nearest(const Rational& q);

// The Real nearest to sqrt(numerator / denominator), both >= 0, denominator > 0. Rounded once.
template <class Real>
Real nearest_sqrt(const mpz_class& numerator, const mpz_class& denominator);
template <class Real>
Real nearest_sqrt(const Rational& q) {
  return nearest_sqrt<Real>(q.get_num(), q.get_den());
}

}  // namespace axiscert
