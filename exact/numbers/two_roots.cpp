#include "exact/numbers/two_roots.h"

namespace axiscert {

TwoRoots TwoRootField::product(const TwoRoots& x, const TwoRoots& y) const {
  return {x.a * y.a + x.b * y.b * p_ + x.c * y.c * q_ + x.d * y.d * p_ * q_,
          x.a * y.b + x.b * y.a + (x.c * y.d + x.d * y.c) * q_, x.a * y.c + x.c * y.a + (x.b * y.d + x.d * y.b) * p_,
          x.a * y.d + x.d * y.a + x.b * y.c + x.c * y.b};
}

int TwoRootField::sign(const Rational& a, const Rational& b) const {
  const int first = sgn(a), second = sgn(p_) == 0 ? 0 : sgn(b);
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  return first * cmp(Rational(a * a), Rational(b * b * p_));
}

// x = u + v sqrt(q), u and v with sqrt(p) alone: where their signs differ, u^2 against v^2 q decides.
int TwoRootField::sign(const TwoRoots& x) const {
  const int first = sign(x.a, x.b), second = sgn(q_) == 0 ? 0 : sign(x.c, x.d);
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  const Rational rational = x.a * x.a + x.b * x.b * p_ - (x.c * x.c + x.d * x.d * p_) * q_,
                 with_root = 2 * (x.a * x.b - x.c * x.d * q_);
  return first * sign(rational, with_root);
}

}  // namespace axiscert
