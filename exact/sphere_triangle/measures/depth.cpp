#include "exact/sphere_triangle/measures/depth.h"

#include <algorithm>
#include <cmath>

#include "exact/sphere_triangle/filters/distance_bounds.h"

namespace axiscert {
namespace {

template <class Real>
Rational squared_length(const Vec3<Real>& v, const Vec3<Real>& p) {
  const Rational x = exact(v.x) - exact(p.x), y = exact(v.y) - exact(p.y), z = exact(v.z) - exact(p.z);
  return x * x + y * y + z * z;
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
  const EnclosedNumber<T> enclosed_r = enclosed_difference<T>(r, 0, triangle.scaling_error);
  const EnclosedNumber<T> residual = d.numerator - enclosed_r * enclosed_r * d.divisor;
  const double least = residual.low() - d.below, greatest = residual.high() + d.above;
  const double divisor_low = as_double(d.divisor).low(), divisor_high = as_double(d.divisor).high();
  if (!(divisor_low > 0) || !(least <= greatest)) return {};
  const double margin = std::max(std::fabs(least), std::fabs(greatest)) * 0x1p-50;
  const double nearest = std::max({least - margin, -greatest - margin, 0.0});
  const double farthest = std::max(std::fabs(least), std::fabs(greatest)) + margin;

  const double r_low = positive_part(as_double(enclosed_r).low()), r_high = as_double(enclosed_r).high();
  const EnclosedNumber<double> numerator = as_double(d.numerator);
  const double d_low = std::sqrt(quotient_low(positive_part(numerator.low() - d.below * more), divisor_high)) * less;
  double d_high = std::sqrt(quotient_high(numerator.high() + d.above, divisor_low)) * more;
  double length_low = r_low, length_high = r_high;
  for (const auto& v : triangle.vertex) {
    const EnclosedNumber<double> square = dot(as_doubles(v), as_doubles(v));
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
