// Numbers with one root, exact until they are shown.
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

}  // namespace axiscert
