#include "fuzz/shrink/image_map.h"

#include <algorithm>
#include <cmath>

namespace axiscert {
namespace {

Query<Rational> in_rationals(const Query<double>& q) {
  std::array<Rational, coordinate_count> exact_numbers;
  const auto v = coordinates(q);
  std::transform(v.begin(), v.end(), exact_numbers.begin(), [](double x) { return exact(x); });
  return from_coordinates(exact_numbers);
}

Rational power_of_two(int exponent) {
  mpz_class power = 1;
  power <<= static_cast<mp_bitcnt_t>(std::abs(exponent));
  return exponent < 0 ? Rational(mpz_class(1), power) : Rational(power);
}

// The greatest |coordinate| of A - P, B - P, C - P, and r: the same for all images but for the power of two.
Rational extent_of(const Query<Rational>& q) {
  Rational greatest = q.r;
  for (const Vec3<Rational>* v : {&q.a, &q.b, &q.c}) {
    for (const Rational& x : {Rational(v->x - q.p.x), Rational(v->y - q.p.y), Rational(v->z - q.p.z)}) {
      greatest = std::max(greatest, Rational(abs(x)));
    }
  }
  return greatest;
}

// The exponent of a power of two; empty for other numbers.
std::optional<int> exponent_of(const Rational& x) {
  const auto log2 = [](const mpz_class& n) { return static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2)) - 1; };
  const int exponent = log2(x.get_num()) - log2(x.get_den());
  return x == power_of_two(exponent) ? std::optional(exponent) : std::nullopt;
}

Query<Rational> mapped(const ImageMap& map, const Query<Rational>& q) {
  auto v = coordinates(image(q, map.symmetry));
  const Rational factor = power_of_two(map.exponent);
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    v[k] *= factor;
    if (k + 1 < coordinate_count) v[k] += map.by[k % 3];
  }
  return from_coordinates(v);
}

}  // namespace

template <class Real>
std::optional<ImageMap> map_between(const Query<Real>& base, const Query<Real>& image_of_it) {
  const Query<Rational> from = in_rationals(widened(base)), to = in_rationals(widened(image_of_it));
  const Rational extent = extent_of(from), other = extent_of(to);
  if ((sgn(extent) == 0) != (sgn(other) == 0)) return std::nullopt;
  std::optional<int> exponent = 0;
  if (sgn(extent) != 0) exponent = exponent_of(Rational(other / extent));
  if (!exponent) return std::nullopt;
  for (const Symmetry& symmetry : symmetries()) {
    ImageMap map{symmetry, *exponent, {}};
    const Query<Rational> moved = mapped(map, from);
    map.by = {Rational(to.p.x - moved.p.x), Rational(to.p.y - moved.p.y), Rational(to.p.z - moved.p.z)};
    if (coordinates(mapped(map, from)) == coordinates(to)) return map;
  }
  return std::nullopt;
}
template std::optional<ImageMap> map_between(const Query<float>&, const Query<float>&);
template std::optional<ImageMap> map_between(const Query<double>&, const Query<double>&);

template <class Real>
std::optional<Query<Real>> image_by(const ImageMap& map, const Query<Real>& q) {
  const auto exact_numbers = coordinates(mapped(map, in_rationals(widened(q))));
  std::array<Real, coordinate_count> v;
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    v[k] = nearest<Real>(exact_numbers[k]);
    if (!std::isfinite(v[k]) || exact(v[k]) != exact_numbers[k]) return std::nullopt;
  }
  return from_coordinates(v);
}
template std::optional<Query<float>> image_by(const ImageMap&, const Query<float>&);
template std::optional<Query<double>> image_by(const ImageMap&, const Query<double>&);

}  // namespace axiscert
