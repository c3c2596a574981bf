// A rational as a number type of the formulae (kernel/formulae_kernel.h). Every result is a number of this type, and
// not an expression of GMP's that refers to its operands.
#pragma once

#include "exact/numbers/rational.h"

namespace axiscert {

struct ExactNumber {
  Rational value;

  ExactNumber() = default;
  explicit ExactNumber(double x) : value(x) {}  // finite
  explicit ExactNumber(Rational x) : value(std::move(x)) {}

  const Rational& rational() const { return value; }

  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) { return of(a.value + b.value); }
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) { return of(a.value - b.value); }
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) { return of(a.value * b.value); }
  // For formulae that divide in a stated place; b is not 0.
  friend ExactNumber operator/(const ExactNumber& a, const ExactNumber& b) { return of(a.value / b.value); }
  friend ExactNumber magnitude(const ExactNumber& a) { return of(abs(a.value)); }
  friend bool operator>(const ExactNumber& a, const ExactNumber& b) { return a.value > b.value; }
  friend bool operator>=(const ExactNumber& a, const ExactNumber& b) { return a.value >= b.value; }

 private:
  template <class Expression>
  static ExactNumber of(const Expression& x) {
    return ExactNumber(Rational(x));
  }
};

}  // namespace axiscert
