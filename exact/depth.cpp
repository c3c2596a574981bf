#include "exact/depth.h"

#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace axiscert {
namespace {

template <class Real>
Rational squared_length(const Vec3<Real>& v, const Vec3<Real>& p) {
  const Rational x = exact(v.x) - exact(p.x), y = exact(v.y) - exact(p.y), z = exact(v.z) - exact(p.z);
  return x * x + y * y + z * z;
}

// The sign of |d - r| - y s, where d^2 = dd, s^2 = ss and r, y >= 0, decided in rationals: squared, it is that of
// x - 2 r d with x = dd + r^2 - y^2 ss, and so of x^2 - 4 r^2 dd unless x is negative.
int order_against(const Rational& y, const Rational& dd, const Rational& r, const Rational& ss) {
  const Rational x = dd + r * r - y * y * ss;
  return sgn(x) < 0 ? -1 : cmp(x * x, 4 * r * r * dd);
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

}  // namespace

template <class Real>
double depth(const Query<Real>& q, const Rational& dd) {
  const Rational r = exact(q.r);
  const Rational ss =
      std::max({squared_length(q.a, q.p), squared_length(q.b, q.p), squared_length(q.c, q.p), Rational(r * r)});
  if (sgn(ss) == 0) return 0;
  // The nearest double is the one between whose midpoints the value lies; on a midpoint, the even one.
  double y = estimate(dd, r, ss);
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
template double depth<float>(const Query<float>&, const Rational&);
template double depth<double>(const Query<double>&, const Rational&);

}  // namespace axiscert
