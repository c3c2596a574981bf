// d^2 = N / D with the integers of the nearest feature: A.A over 1 for vertex A, |A x B|^2 over |AB|^2 for edge AB, d^2
// over |V|^2 for the face. Nothing is rounded before these are known, nor in the difference that cancels, M = N - r^2
// D:
//
//   |d - r| / s = |M| / (D (d + r) s),  s^2 = S = max(A.A, B.B, C.C, r^2),  d = sqrt(N / D)
//
// are conversions, sums, products, quotients and roots of non-negative numbers. With relative errors in u, the unit
// roundoff of Enclosing: N, D, r, S, M 1 each; N / D 3; d 2.5; d + r 3.5, from the greater of its terms' errors and its
// own rounding; D (d + r) 5.5; s 1.5; all of the divisor 8; the quotient 10.
#include "exact/sphere_triangle/measures/grid_distance.h"

#include <cmath>

#include "exact/sphere_triangle/filters/grid.h"
#include "exact/numbers/mpfr_number.h"

namespace axiscert {
namespace {

using EnclosingNumber = Mpfr<192>;  // u = 2^-192; unbounded exponents
// More than 10 u plus the rounding of the bounds themselves and all second-order terms.
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

template <class Real>
std::optional<double> depth_on_grid(const Query<Real>& q) {
  const auto on_grid = on_any_grid(q);
  const Gram<AnyGrid<Real>> g(on_grid.centred);
  const Square d2 = nearest_square(g);
  if (mpfr_zero_p(d2.margin.get())) return 0;
  const auto greater = [](const auto& x, const auto& y) -> const auto& { return (x - y).is_negative() ? y : x; };
  const EnclosingNumber length2 = enclosing(greater(greater(g.aa, g.bb), greater(g.cc, g.rr)));
  const EnclosingNumber r = enclosing(on_grid.centred[9]);
  const EnclosingNumber sum = square_root(d2.numerator / d2.divisor) + r;
  return certainly_rounded<double>(magnitude(d2.margin) / (d2.divisor * sum * square_root(length2)));
}
template std::optional<double> depth_on_grid<float>(const Query<float>&);
template std::optional<double> depth_on_grid<double>(const Query<double>&);

template <class Real>
std::optional<Real> distance_on_grid(const Query<Real>& q) {
  const auto on_grid = on_any_grid(q);
  const Square d2 = nearest_square(Gram<AnyGrid<Real>>(on_grid.centred));
  return certainly_rounded<Real>(square_root(d2.numerator / d2.divisor) *
                                 EnclosingNumber(std::ldexp(1.0, on_grid.unit)));
}
template std::optional<float> distance_on_grid<float>(const Query<float>&);
template std::optional<double> distance_on_grid<double>(const Query<double>&);

}  // namespace axiscert
