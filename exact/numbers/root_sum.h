// Sums of up to three roots of rationals, each times a rational: their signs, exactly.
#pragma once

#include <functional>

#include "exact/numbers/rational.h"

namespace axiscert {

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
