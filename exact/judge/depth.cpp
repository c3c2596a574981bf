#include "exact/judge/depth.h"

#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "exact/numbers/floating.h"

namespace axiscert {
namespace {

// The signs of a + b sqrt(p) and of a + b sqrt(p) + c sqrt(q), p and q >= 0: if two terms differ in sign, their squares
// decide.
int sign_of(const Rational& a, const Rational& b, const Rational& p) {
  const int first = sgn(a), second = sgn(p) == 0 ? 0 : sgn(b);
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  return first * cmp(Rational(a * a), Rational(b * b * p));
}
int sign_of(const Rational& a, const Rational& b, const Rational& p, const Rational& c, const Rational& q) {
  const int first = sign_of(a, b, p), second = sgn(q) == 0 ? 0 : sgn(c);
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  return first * sign_of(a * a + b * b * p - c * c * q, 2 * a * b, p);
}

// The sign of |d - r| - y s, where d^2 = dd, s^2 = ss and y >= 0: that of its squares' difference.
int order_against(const Rational& y, const Rational& dd, const Rational& r, const Rational& ss) {
  return sign_of(dd + r * r - y * y * ss, -2 * r, dd);
}

// |sqrt(dd) - r| / sqrt(ss), rounded from an absolute error below 2^-2390: beyond the least double by more than a
// thousand bits, so at most one step from the nearest one.
double estimate(const Rational& dd, const Rational& r, const Rational& ss) {
  mpfr_t d, s;
  mpfr_inits2(2400, d, s, nullptr);
  mpfr_set_q(d, dd.get_mpq_t(), MPFR_RNDN);
  mpfr_sqrt(d, d, MPFR_RNDN);
  mpfr_sub_q(d, d, r.get_mpq_t(), MPFR_RNDN);
  mpfr_abs(d, d, MPFR_RNDN);
  mpfr_set_q(s, ss.get_mpq_t(), MPFR_RNDN);
  mpfr_sqrt(s, s, MPFR_RNDN);
  mpfr_div(d, d, s, MPFR_RNDN);
  const double result = mpfr_get_d(d, MPFR_RNDN);
  mpfr_clears(d, s, nullptr);
  return result;
}

// The double before the greatest.
const double below_most = std::nextafter(std::numeric_limits<double>::max(), 0.0);

}  // namespace

// Compares the squares (dd + r^2 - 2 r sqrt(dd)) / ss over the common denominator.
int compare(const ExactDepth& x, const ExactDepth& y) {
  return sign_of((x.dd + x.r * x.r) * y.ss - (y.dd + y.r * y.r) * x.ss, -2 * x.r * y.ss, x.dd, 2 * y.r * x.ss, y.dd);
}

double rounded_length(const ExactDepth& depth) {
  const double most = std::numeric_limits<double>::max();
  if (order_against((exact(below_most) + exact(most)) / 2, depth.dd, depth.r, 1) >= 0) return most;
  return rounded_depth({depth.dd, depth.r, 1});
}

double rounded_depth(const ExactDepth& depth) {
  const auto& [dd, r, ss] = depth;
  if (sgn(r) == 0) return nearest_sqrt<double>(Rational(dd / ss));
  // The nearest double is the one whose adjacent midpoints enclose the value; a value on a midpoint goes to the even
  // one.
  double y = std::min(estimate(dd, r, ss), below_most);  // lengths that may round to more do not come here
  for (;;) {
    const double up = std::nextafter(y, INFINITY), down = std::nextafter(y, 0.0);
    const bool odd = (std::bit_cast<std::uint64_t>(y) & 1) != 0;
    const int above = order_against((exact(y) + exact(up)) / 2, dd, r, ss);
    if (above > 0 || (above == 0 && odd)) {
      y = up;
      continue;
    }
    if (y == 0) return y;
    const int below = order_against((exact(y) + exact(down)) / 2, dd, r, ss);
    if (below > 0 || (below == 0 && !odd)) return y;
    y = down;
  }
}

}  // namespace axiscert
