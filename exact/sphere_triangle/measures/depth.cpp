#include "exact/sphere_triangle/measures/depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/numbers/mpfr_number.h"
#include "exact/sphere_triangle/measures/input_class.h"
#include "exact/sphere_triangle/oracles/distance_bounds.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/oracles/grid.h"

namespace axiscert {

// d^2 = N / D with the integers of the nearest feature: A.A over 1 for vertex A, |A x B|^2 over |AB|^2 for edge AB, d^2
// over |V|^2 for the face. Nothing is rounded before these are known, nor in the difference that cancels, M = N - r^2
// D:
//
//   |d - r| / s = |M| / (D (d + r) s),  s^2 = S = max(A.A, B.B, C.C, r^2),  d = sqrt(N / D)
//
// are conversions, sums, products, quotients and roots of non-negative numbers. With relative errors in u, the unit
// roundoff of Enclosing: N, D, r, S, M 1 each; N / D 3; d 2.5; d + r 3.5, from the greater of its terms' errors and its
// own rounding; D (d + r) 5.5; s 1.5; all of the divisor 8; the quotient 10, by two divisors 11.

namespace {

using EnclosingNumber = Mpfr<192>;  // u = 2^-192; unbounded exponents
// More than 11 u plus the rounding of the bounds themselves and all second-order terms.
constexpr double enclosing_error = 0x1p-180;

template <std::size_t words>
EnclosingNumber enclosing(const LimbInteger<words>& x) {
  return x.as_mpz([](mpz_srcptr z) { return EnclosingNumber::of(z); });
}

template <class Real>
Real rounded(const EnclosingNumber& x) {
  if constexpr (sizeof(Real) == 4) return mpfr_get_flt(x.get(), MPFR_RNDN);
  else return mpfr_get_d(x.get(), MPFR_RNDN);
}

// The value to which every number within the error of x rounds, if there is one. Rounding is monotone, so the two ends
// decide.
template <class Real>
std::optional<Real> certainly_rounded(const EnclosingNumber& x) {
  const EnclosingNumber one(1), error(enclosing_error);
  const Real low = rounded<Real>(x * (one - error)), high = rounded<Real>(x * (one + error));
  return low == high ? std::optional(low) : std::nullopt;
}

// d^2 = numerator / divisor, and the margin = numerator - r^2 divisor, rounded from exact values.
struct Square {
  EnclosingNumber numerator, divisor, margin;
};

// The squared distance to the nearest feature, which the signs of comparisons without the radius determine:
//   vertex A  A.(B - A) >= 0 and A.(C - A) >= 0: the triangle lies beyond the plane through A perpendicular to vector A
//   edge AB   the foot on the line is strictly between its ends, and (A x B).V <= 0: the plane's foot is not within
//   face      otherwise, and then V is not zero: in a triangle without area the nearest point is a vertex or on an edge
template <class Numbers>
Square nearest_square(const Gram<Numbers>& g) {
  using Degree2 = typename Numbers::Degree2;
  using Degree4 = typename Numbers::Degree4;
  const auto is_nearest = [](const Degree2& xx, const Degree2& xy, const Degree2& xz) {
    return !(xy - xx).is_negative() && !(xz - xx).is_negative();
  };
  for (const Degree2* xx : {&g.aa, &g.bb, &g.cc}) {
    const Degree2 &xy = xx == &g.cc ? g.ac : g.ab, &xz = xx == &g.aa ? g.ac : g.bc;
    if (is_nearest(*xx, xy, xz)) return {enclosing(*xx), EnclosingNumber(1), enclosing(*xx - g.rr)};
  }
  struct Edge {
    const Degree2 &xx, &xy, &yy;
    const Degree4 &nn, &nv;
  };
  for (const Edge& e : {Edge{g.aa, g.ab, g.bb, g.n11, g.n1v}, Edge{g.bb, g.bc, g.cc, g.n22, g.n2v},
                        Edge{g.cc, g.ac, g.aa, g.n33, g.n3v}}) {
    const bool is_between = (e.xy - e.xx).is_negative() && (e.xy - e.yy).is_negative();
    if (!is_between || !(e.nv.is_zero() || e.nv.is_negative())) continue;
    const Degree2 length2 = g.edge2(e.xx, e.xy, e.yy);
    return {enclosing(e.nn), enclosing(length2), enclosing(e.nn - g.rr * length2)};
  }
  return {enclosing(g.dd), enclosing(g.vv), enclosing(g.dd - g.rr * g.vv)};
}

}  // namespace

namespace {

// |d - r| in units of the grid as `finish(|d - r|, grid, gram)` goes on with it, rounded once.
template <class Real, class Finish>
std::optional<double> distance_from_touching(const Query<Real>& q, Finish&& finish) {
  const auto on_grid = on_any_grid(q);
  const Gram<AnyGrid<Real>> g(on_grid.centred);
  const Square d2 = nearest_square(g);
  if (mpfr_zero_p(d2.margin.get())) return 0;
  const EnclosingNumber sum = square_root(d2.numerator / d2.divisor) + enclosing(on_grid.centred[9]);
  return certainly_rounded<double>(finish(magnitude(d2.margin) / (d2.divisor * sum), on_grid, g));
}

}  // namespace

template <class Real>
std::optional<double> depth_on_grid(const Query<Real>& q) {
  return distance_from_touching(q, [](const EnclosingNumber& length, const auto&, const auto& g) {
    const auto greater = [](const auto& x, const auto& y) -> const auto& { return (x - y).is_negative() ? y : x; };
    return length / square_root(enclosing(greater(greater(g.aa, g.bb), greater(g.cc, g.rr))));
  });
}
template std::optional<double> depth_on_grid<float>(const Query<float>&);
template std::optional<double> depth_on_grid<double>(const Query<double>&);

template <class Real>
std::optional<double> length_on_grid(const Query<Real>& q) {
  const auto in_unit = [](const EnclosingNumber& length, const auto& on_grid, const auto&) {
    return length * EnclosingNumber(std::ldexp(1.0, on_grid.unit));
  };
  const std::optional<double> length = distance_from_touching(q, in_unit);
  return length ? std::optional(std::min(*length, std::numeric_limits<double>::max())) : std::nullopt;
}
template std::optional<double> length_on_grid<float>(const Query<float>&);
template std::optional<double> length_on_grid<double>(const Query<double>&);

template <class Real>
std::optional<Real> distance_on_grid(const Query<Real>& q) {
  const auto on_grid = on_any_grid(q);
  const Square d2 = nearest_square(Gram<AnyGrid<Real>>(on_grid.centred));
  return certainly_rounded<Real>(square_root(d2.numerator / d2.divisor) *
                                 EnclosingNumber(std::ldexp(1.0, on_grid.unit)));
}
template std::optional<float> distance_on_grid<float>(const Query<float>&);
template std::optional<double> distance_on_grid<double>(const Query<double>&);

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

namespace {

// The divisor of the depth, max(|A-P|, |B-P|, |C-P|, r), but for roundings: vectors over their greatest component, so
// that no square overflows, and one that underflows is far below the sum, which is at least 1.
template <class Real>
double scene_at_most(const Query<Real>& q) {
  const Query<double>& wide = widened(q);
  double greatest = wide.r;
  for (const Vec3<double>* vertex : {&wide.a, &wide.b, &wide.c}) {
    const Vec3<double> v = *vertex - wide.p;
    const double size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (size == 0) continue;
    if (!std::isfinite(size)) return size;
    const double x = v.x / size, y = v.y / size, z = v.z / size;
    greatest = std::max(greatest, std::sqrt(x * x + y * y + z * z) * size);
  }
  return greatest;
}

}  // namespace

template <class Real>
const Rational& LazyDistance<Real>::squared() {
  if (!squared_) squared_ = squared_distance(query_);
  return *squared_;
}
template <class Real>
std::optional<Real> LazyDistance<Real>::within(const RadiusRange<Real>& range) {
  if (exact_only_) return distance_within(squared(), range);
  if (!rounded_) rounded_ = rounded_distance(query_);
  return rounded_distance_within(*rounded_, range);
}
template <class Real>
const DepthRange& LazyDistance<Real>::range() {
  if (!range_) range_ = exact_only_ ? DepthRange{exactly(), exactly()} : depth_range(query_);
  return *range_;
}
template <class Real>
double LazyDistance<Real>::at_least() {
  return range().low;
}
template <class Real>
double LazyDistance<Real>::at_most() {
  return range().high;
}
template <class Real>
double LazyDistance<Real>::engine_threshold() {
  return is_engine_like(query_) ? engine_depth<Real> : std::numeric_limits<double>::infinity();
}
template <class Real>
double LazyDistance<Real>::exactly() {
  if (!depth_ && !exact_only_) depth_ = depth_on_grid(query_);
  if (!depth_) depth_ = depth(query_, squared());
  return *depth_;
}
template <class Real>
double LazyDistance<Real>::length() {
  if (is_touching_) return 0;
  const std::optional<double> by_integers = exact_only_ ? std::nullopt : length_on_grid(query_);
  return by_integers ? *by_integers : rounded_length(exact_depth(query_, squared()));
}
template <class Real>
double LazyDistance<Real>::length_at_most() {
  if (is_touching_) return 0;
  // Twelve roundings at most, each of 2^-53 or less; where numbers are subnormal the terms that are added, the first
  // for the rounding of the depth.
  return (at_most() + 0x1p-1074) * scene_at_most(query_) * (1 + 0x1p-48) + 0x1p-1070;
}
template <class Real>
void LazyDistance<Real>::set_touching() {
  is_touching_ = true;
  if (exact_only_) return;
  range_ = DepthRange{0, 0};
  depth_ = 0;
}
template class LazyDistance<float>;
template class LazyDistance<double>;

}  // namespace axiscert
