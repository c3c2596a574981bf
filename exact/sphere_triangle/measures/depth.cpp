#include "exact/sphere_triangle/measures/depth.h"

#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "exact/sphere_triangle/filters/distance_bounds.h"

namespace axiscert {
namespace {

template <class Real>
Rational squared_length(const Vec3<Real>& v, const Vec3<Real>& p) {
  const Rational x = exact(v.x) - exact(p.x), y = exact(v.y) - exact(p.y), z = exact(v.z) - exact(p.z);
  return x * x + y * y + z * z;
}

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

// Not less than the vector's length, even where squares of its components underflow.
template <class T>
double length_at_most(const EnclosedVector<T>& v) {
  const EnclosedVector<double> w = as_doubles(v);
  return (w.size + 4 * w.error) * more;  // 3, and what `more` lies beyond an error
}

// Whether the depth is certainly within half an ulp (2^-54) below 1, so that it rounds to 1, which is even. Either the
// vertices are all so near the centre that the divisor is r and the depth 1 - d / r; or the triangle and r are so small
// that every point of it is nearly as far away as the farthest vertex: d is that less an edge at most, and the divisor
// it.
template <class T>
bool rounds_to_one(const EnclosedTriangle<T>& triangle, double r_low, double r_high, double length_low) {
  double farthest = 0, longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    farthest = std::max(farthest, length_at_most(triangle.vertex[i]));
    longest = std::max(longest, length_at_most(triangle.edge[i]));
  }
  return (r_low > 0 && farthest <= r_low * 0x1p-54) || (length_low > 0 && longest + r_high <= length_low * 0x1p-55);
}

// (d - r) (d + r) D = N - r^2 D where d^2 = N / D: cancellation occurs only in the residual, which is enclosed. Sums,
// products, quotients and roots of positive doubles follow, at most ten, which `more` and `less` cover. Nothing
// overflows: the greatest is r^2 times the divisor, below 2^262 2^530.
template <class T>
DepthRange range_of(const EnclosedTriangle<T>& triangle, double radius) {
  const EnclosedSquare<T> d = distance_bounds(triangle);
  const double r = std::ldexp(radius, triangle.exponent);
  if (!(r <= 0x1p130)) return rounds_to_one(triangle, r, r, 0) ? DepthRange{1, 1} : DepthRange{};
  const Enclosed<T> enclosed_r = enclosed_difference<T>(r, 0, triangle.scaling_error);
  const Enclosed<T> residual = d.numerator - enclosed_r * enclosed_r * d.divisor;
  const double least = residual.low() - d.below, greatest = residual.high() + d.above;
  const double divisor_low = as_double(d.divisor).low(), divisor_high = as_double(d.divisor).high();
  if (!(divisor_low > 0) || !(least <= greatest)) return {};
  const double margin = std::max(std::fabs(least), std::fabs(greatest)) * 0x1p-50;
  const double nearest = std::max({least - margin, -greatest - margin, 0.0});
  const double farthest = std::max(std::fabs(least), std::fabs(greatest)) + margin;

  const double r_low = positive_part(as_double(enclosed_r).low()), r_high = as_double(enclosed_r).high();
  const Enclosed<double> numerator = as_double(d.numerator);
  const double d_low = std::sqrt(quotient_low(positive_part(numerator.low() - d.below * more), divisor_high)) * less;
  double d_high = std::sqrt(quotient_high(numerator.high() + d.above, divisor_low)) * more;
  double length_low = r_low, length_high = r_high;
  for (const auto& v : triangle.vertex) {
    const Enclosed<double> square = dot(as_doubles(v), as_doubles(v));
    length_low = std::max(length_low, std::sqrt(positive_part(square.low())));
    length_high = std::max(length_high, std::sqrt(square.high()));
    d_high = std::min(d_high, length_at_most(v));  // which is tight where the other vertices are far away
  }
  const double low = quotient_low(nearest, divisor_high) / (d_high + r_high) / length_high * less - 0x1p-1073;
  // If d and r are both near zero the quotient gives no bound; their own sizes do.
  const double apart = std::max(d_high - r_low, r_high - d_low) / length_low * more + 0x1p-1073;
  const double high = quotient_high(farthest, divisor_low) / (d_low + r_low) / length_low * more + 0x1p-1073;
  const double least_high = high < apart ? high : apart;
  const auto known = [](double x) { return x > 0 ? x : 0; };  // 0 for NaN too
  if (!(least_high < 1)) return {rounds_to_one(triangle, r_low, r_high, length_low) ? 1 : known(low), 1};
  if (low > 0) return {low, least_high};
  return {known(std::max(d_low - r_high, r_low - d_high) / length_high * less - 0x1p-1073), least_high};
}

}  // namespace

template <class Real>
ExactDepth exact_depth(const Query<Real>& q, const Rational& dd) {
  const Rational r = exact(q.r);
  const Rational ss =
      std::max({squared_length(q.a, q.p), squared_length(q.b, q.p), squared_length(q.c, q.p), Rational(r * r)});
  return {dd, r, sgn(ss) == 0 ? Rational(1) : ss};  // if the divisor is 0, so are d and r
}
template ExactDepth exact_depth<float>(const Query<float>&, const Rational&);
template ExactDepth exact_depth<double>(const Query<double>&, const Rational&);

// Compares the squares (dd + r^2 - 2 r sqrt(dd)) / ss over the common denominator.
int compare(const ExactDepth& x, const ExactDepth& y) {
  return sign_of((x.dd + x.r * x.r) * y.ss - (y.dd + y.r * y.r) * x.ss, -2 * x.r * y.ss, x.dd, 2 * y.r * x.ss, y.dd);
}

double rounded_depth(const ExactDepth& depth) {
  const auto& [dd, r, ss] = depth;
  // The nearest double is the one whose adjacent midpoints enclose the value; a value on a midpoint goes to the even
  // one.
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
template <class Real>
double depth(const Query<Real>& q, const Rational& squared_distance) {
  return rounded_depth(exact_depth(q, squared_distance));
}
template double depth<float>(const Query<float>&, const Rational&);
template double depth<double>(const Query<double>&, const Rational&);

template <class Real>
DepthRange depth_range(const Query<Real>& q) {
  if constexpr (sizeof(Real) == 4) return range_of(enclosed_triangle_of(q), q.r);
  else return range_of(doubled_triangle_of(q), q.r);
}
template DepthRange depth_range<float>(const Query<float>&);
template DepthRange depth_range<double>(const Query<double>&);

}  // namespace axiscert
