#include "exact/judge/contact_numbers.h"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/numbers/roots.h"

namespace axiscert {
namespace {

using portable::cross;
using portable::dot;

// The square of how far a point is along a direction, per unit; 0 where it is behind, or there is no direction.
Rational squared_along(const RationalVector& at, const RationalVector& direction) {
  const Rational along = dot(at, direction);
  if (sgn(along) <= 0) return 0;
  return along * along / dot(direction, direction);
}

}  // namespace

std::optional<RationalVector> vector_at(std::span<const double> measures, std::size_t first) {
  if (measures.size() < first + 3) return std::nullopt;
  const auto is_finite = [](double x) { return std::isfinite(x); };
  if (!std::all_of(measures.begin() + static_cast<std::ptrdiff_t>(first),
                   measures.begin() + static_cast<std::ptrdiff_t>(first + 3), is_finite)) {
    return std::nullopt;
  }
  return RationalVector{exact(measures[first]), exact(measures[first + 1]), exact(measures[first + 2])};
}

std::array<double, 3> rounded(const RationalVector& v) {
  return {nearest<double>(v.x), nearest<double>(v.y), nearest<double>(v.z)};
}
// v / |v|, for a v that is not zero.
std::array<double, 3> unit_vector(const RationalVector& v) {
  const Rational squared = dot(v, v);
  const auto share = [&](const Rational& x) {
    const double size = nearest_sqrt<double>(Rational(x * x / squared));
    return sgn(x) < 0 ? -size : size;
  };
  return {share(v.x), share(v.y), share(v.z)};
}

double angle_between(const RationalVector& a, const RationalVector& b) {
  const Rational squares = dot(a, a) * dot(b, b), along = dot(a, b);
  Rational half_chord_squared = 1;
  if (sgn(squares) != 0) {
    const Rational lengths = root_below(squares);
    // sin^2 of half the angle, (1 - cos) / 2, without a difference where that would cancel.
    if (sgn(along) > 0) half_chord_squared = (squares - along * along) / (2 * lengths * (lengths + along));
    else half_chord_squared = std::min(Rational(1), Rational((1 - along / lengths) / 2));
  }
  MPFR_DECL_INIT(angle, 53);
  mpfr_set_d(angle, nearest_sqrt<double>(half_chord_squared), MPFR_RNDN);
  mpfr_asin(angle, angle, MPFR_RNDN);
  return 2 * mpfr_get_d(angle, MPFR_RNDN);
}

double length_error(const RationalVector& n) {
  // Without a difference of roots: (n.n - 1) / (|n| + 1).
  const Rational squared = dot(n, n);
  return std::min(nearest<double>(Rational(abs(Rational(squared - 1)) / (root_below(squared) + 1))),
                  std::numeric_limits<double>::max());
}

template <class Real>
SeparationError separation_error(double given, const Rational& squared, const Rational& r,
                                 const Rational& squared_scene) {
  constexpr double most = std::numeric_limits<double>::max();
  // y - s = (y + r) - sqrt(squared), relatively to 2^-240.
  const Rational error = approximate_magnitude({exact(given) + r, squared, -1});
  SeparationError found;
  if (sgn(error) == 0) return found;
  const Rational in_scenes = error / root_below(squared_scene);
  found.share = std::min(nearest<double>(in_scenes), most);
  found.length = std::min(nearest<double>(error), most);
  found.in_u = round_up(Rational(in_scenes * Rational(mpz_class(1) << std::numeric_limits<Real>::digits)));
  const auto best = std::min(nearest<Real>(approximate_magnitude({r, squared, -1})), std::numeric_limits<Real>::max());
  const Real next = std::nextafter(best, std::numeric_limits<Real>::infinity());
  const Rational ulp =
      std::isinf(next) ? exact(best) - exact(std::nextafter(best, Real(0))) : exact(next) - exact(best);
  found.ulps = round_up(Rational(error / ulp));
  return found;
}
template SeparationError separation_error<float>(double, const Rational&, const Rational&, const Rational&);
template SeparationError separation_error<double>(double, const Rational&, const Rational&, const Rational&);

std::optional<std::size_t> part_named(double number) {
  for (std::size_t part = 0; part < triangle_parts; ++part) {
    if (number == static_cast<double>(part)) return part;
  }
  return std::nullopt;
}

// A region of a triangle is where the centre is beyond the ends of the edges at a vertex; beside an edge, outside;
// above or below the face.
Rational squared_beyond(std::size_t part, const std::array<RationalVector, 3>& vertices, const RationalVector& centre) {
  constexpr std::size_t first_edge = 3, face = 6;
  const auto vertex = [&](std::size_t i) -> const RationalVector& { return vertices[i % 3]; };
  if (part < first_edge) {
    const RationalVector at = centre - vertex(part);
    return std::max(squared_along(at, vertex(part + 1) - vertex(part)),
                    squared_along(at, vertex(part + 2) - vertex(part)));
  }
  const RationalVector normal = cross(vertices[1] - vertices[0], vertices[2] - vertices[0]);
  const auto outwards = [&](std::size_t k) { return cross(vertex(k + 1) - vertex(k), normal); };
  Rational most = 0;
  if (part == face) {
    for (const std::size_t k : {0u, 1u, 2u}) most = std::max(most, squared_along(centre - vertex(k), outwards(k)));
    return most;
  }
  const RationalVector along = vertex(part + 1) - vertex(part);
  most = std::max(squared_along(centre - vertex(part + 1), along), squared_along(vertex(part) - centre, along));
  return std::max(most, squared_along(vertex(part) - centre, outwards(part)));
}

}  // namespace axiscert
