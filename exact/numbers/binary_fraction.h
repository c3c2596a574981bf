// A quotient of two binary numbers: exact, and without the greatest common divisors of rationals.
#pragma once

#include "exact/numbers/binary_number.h"
#include "exact/numbers/rational.h"

namespace axiscert {

// over / under; `under` is positive. Quotients of one denominator keep it in a sum, others multiply theirs, so it
// serves for formulae that divide in a stated place, and not for a loop.
struct BinaryFraction {
  BinaryNumber over, under = BinaryNumber::one();

  BinaryFraction() = default;
  explicit BinaryFraction(double x) : over(x) {}  // finite
  explicit BinaryFraction(BinaryNumber x) : over(std::move(x)) {}
  BinaryFraction(BinaryNumber above, BinaryNumber below) : over(std::move(above)), under(std::move(below)) {}
  explicit BinaryFraction(const Rational& x) : over(x.get_num_mpz_t()), under(x.get_den_mpz_t()) {}

  bool is_whole() const { return under == BinaryNumber::one(); }

  friend BinaryFraction operator+(const BinaryFraction& a, const BinaryFraction& b) {
    if (a.under == b.under) return {a.over + b.over, a.under};
    return {a.over * b.under + b.over * a.under, a.under * b.under};
  }
  friend BinaryFraction operator-(const BinaryFraction& a, const BinaryFraction& b) {
    if (a.under == b.under) return {a.over - b.over, a.under};
    return {a.over * b.under - b.over * a.under, a.under * b.under};
  }
  friend BinaryFraction operator*(const BinaryFraction& a, const BinaryFraction& b) {
    return {a.over * b.over, a.under * b.under};
  }
  // b is not 0.
  friend BinaryFraction operator/(const BinaryFraction& a, const BinaryFraction& b) {
    const BinaryNumber above = a.over * b.under;
    return {b.over.sign() < 0 ? -above : above, a.under * magnitude(b.over)};
  }
  friend BinaryFraction magnitude(const BinaryFraction& a) { return {magnitude(a.over), a.under}; }

  // -1, 0 or 1, as a is less than b, equal or greater.
  friend int order(const BinaryFraction& a, const BinaryFraction& b) {
    if (a.under == b.under) return order(a.over, b.over);
    return order(a.over * b.under, b.over * a.under);
  }
  friend bool operator==(const BinaryFraction& a, const BinaryFraction& b) { return order(a, b) == 0; }
  friend bool operator>(const BinaryFraction& a, const BinaryFraction& b) { return order(a, b) > 0; }
  friend bool operator>=(const BinaryFraction& a, const BinaryFraction& b) { return order(a, b) >= 0; }
};

Rational rational(const BinaryNumber& x);
Rational rational(const BinaryFraction& x);

}  // namespace axiscert
