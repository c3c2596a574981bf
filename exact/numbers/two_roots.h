// Numbers with two roots, exact: sums, products and signs.
#pragma once

#include "exact/numbers/rational.h"

namespace axiscert {

// a + b sqrt(p) + c sqrt(q) + d sqrt(p q), for the p and q of its field, both >= 0. The squares need not be apart: a
// sign is decided by squares, so that it is right where a root is rational, or the product of two is.
struct TwoRoots {
  Rational a, b = 0, c = 0, d = 0;

  friend TwoRoots operator+(const TwoRoots& x, const TwoRoots& y) {
    return {x.a + y.a, x.b + y.b, x.c + y.c, x.d + y.d};
  }
  friend TwoRoots operator-(const TwoRoots& x, const TwoRoots& y) {
    return {x.a - y.a, x.b - y.b, x.c - y.c, x.d - y.d};
  }
  friend TwoRoots operator*(const TwoRoots& x, const Rational& s) { return {x.a * s, x.b * s, x.c * s, x.d * s}; }
};

// The field of sqrt(p) and sqrt(q).
class TwoRootField {
 public:
  TwoRootField(Rational p, Rational q) : p_(std::move(p)), q_(std::move(q)) {}
  TwoRoots product(const TwoRoots& x, const TwoRoots& y) const;
  int sign(const TwoRoots& x) const;  // -1, 0 or 1

 private:
  // The sign of a + b sqrt(p).
  int sign(const Rational& a, const Rational& b) const;

  Rational p_, q_;
};

}  // namespace axiscert
