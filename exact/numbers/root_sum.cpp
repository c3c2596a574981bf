#include "exact/numbers/root_sum.h"

namespace axiscert {
namespace {

int sign_of(const RootTerm& x) { return sgn(x.factor) * sgn(x.square); }
Rational square_of(const RootTerm& x) { return x.factor * x.factor * x.square; }

}  // namespace

int sign_of_sum(const RootTerm& x, const RootTerm& y) {
  const int of_x = sign_of(x), of_y = sign_of(y);
  if (of_x == 0 || of_y == 0 || of_x == of_y) return of_x != 0 ? of_x : of_y;
  return of_x * sgn(Rational(square_of(x) - square_of(y)));
}

int sign_of_sum(const RootTerm& x, const RootTerm& y, const RootTerm& z) {
  const int of_both = sign_of_sum(x, y), of_z = sign_of(z);
  if (of_both == 0 || of_z == 0 || of_both == of_z) return of_both != 0 ? of_both : of_z;
  // (x + y)^2 - z^2, in which one root is left.
  const RootTerm rational{square_of(x) + square_of(y) - square_of(z)};
  return of_both * sign_of_sum(rational, {2 * x.factor * y.factor, Rational(x.square * y.square)});
}

Decimal6 round_up(const Rational& guess, const std::function<int(const Rational& y)>& order) {
  Decimal6 found = round_up(guess);
  if (found.is_zero()) return found;
  while (order(exact(found)) > 0) found = next(found);
  for (Decimal6 less = previous(found); order(exact(less)) <= 0; less = previous(found)) found = less;
  return found;
}

}  // namespace axiscert
