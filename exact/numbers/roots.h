// Numbers with one root or two, and sums of up to three, each times a rational: exact until they are shown.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "exact/numbers/rational.h"

namespace axiscert {

// rest + sqrt(square), or with the sign -1 rest - sqrt(square); square >= 0.
struct RootNumber {
  Rational rest, square = 0;
  int sign = 1;
};
// x / |v| of a component x of a vector, whose squared length is not 0.
inline RootNumber share_of_length(const Rational& x, const Rational& squared_length) {
  return {0, Rational(x * x / squared_length), sgn(x) < 0 ? -1 : 1};
}
// The sign of x - y: -1, 0 or 1.
int compare(const RootNumber& x, const Rational& y);

// Not above sqrt(q), and relatively less than 2^-250 below it; q >= 0.
Rational root_below(const Rational& q);
// sqrt(q), where it is rational.
std::optional<Rational> rational_root(const Rational& q);

// |x|, relatively to 2^-240: nothing cancels.
Rational approximate_magnitude(const RootNumber& x);

// A number that is positive, as the decimal nearest to it with so many significant digits, ties to even, without zeros
// at its end. `order(y)` is the sign of the number less y, exactly, which alone decides; `guess` is near to it.
std::string decimal_text(const Rational& guess, const std::function<int(const Rational& y)>& order, int digits);
std::string decimal_text(const RootNumber& x, int digits);

// The number itself: "3/4", "sqrt(2)", "1/2 - sqrt(1/3)".
std::string exact_text(const RootNumber& x);

// Two roots: sums, products and signs.

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

// Sums of up to three roots, and their signs.

// factor * sqrt(square); square >= 0.
struct RootTerm {
  Rational factor, square = 1;
};
// The sign of the sum: -1, 0 or 1. By squares alone, so nothing is approximated.
int sign_of_sum(const RootTerm& x, const RootTerm& y);
int sign_of_sum(const RootTerm& x, const RootTerm& y, const RootTerm& z);

// The least Decimal6 that is not below a number that is not negative. `order(y)` is the sign of the number less y,
// exactly, which alone decides; `guess` is near to it, and 0 where it is 0.
Decimal6 round_up(const Rational& guess, const std::function<int(const Rational& y)>& order);

}  // namespace axiscert
