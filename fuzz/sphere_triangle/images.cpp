#include "fuzz/sphere_triangle/images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/numbers/rational.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/sphere_triangle/families/parts/images.h"
#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"
#include "fuzz/text/number_text.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

// P at the origin, and everything multiplied by the power of two that makes all numbers integers and at least one odd,
// unless all are zero.
Query<mpz_class> in_integers(const Query<double>& q) {
  auto v = coordinates(q);
  std::array<Rational, coordinate_count> centred;
  mpz_class denominator = 1;
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    centred[k] = k < 9 ? Rational(exact(v[k]) - exact(v[9 + k % 3])) : k < 12 ? Rational(0) : exact(v[k]);
    // powers of two: the greatest is a multiple of all
    denominator = std::max(denominator, mpz_class(centred[k].get_den()));
  }
  std::array<mpz_class, coordinate_count> whole;
  mp_bitcnt_t zeros = ~mp_bitcnt_t{0};
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    whole[k] = Rational(centred[k] * denominator).get_num();
    if (whole[k] != 0) zeros = std::min(zeros, mpz_scan1(whole[k].get_mpz_t(), 0));
  }
  for (mpz_class& x : whole) {
    if (x != 0) x >>= zeros;
  }
  return from_coordinates(whole);
}

// The least of the images, number by number.
template <class T>
std::array<T, coordinate_count> least_image(const Query<T>& q) {
  auto least = coordinates(q);
  for (const Symmetry& symmetry : symmetries()) least = std::min(least, coordinates(image(q, symmetry)));
  return least;
}

// The same result, found over the numbers' ranks by magnitude, with their signs: these are ordered as the numbers are,
// and no integer of thousands of bits is copied 288 times.
std::array<mpz_class, coordinate_count> least_image(const Query<mpz_class>& q) {
  const auto v = coordinates(q);
  std::vector<mpz_class> magnitudes;
  for (const mpz_class& x : v) magnitudes.push_back(abs(x));
  std::sort(magnitudes.begin(), magnitudes.end());
  std::array<int, coordinate_count> places;
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    const auto at = std::lower_bound(magnitudes.begin(), magnitudes.end(), mpz_class(abs(v[k])));
    places[k] = sgn(v[k]) * static_cast<int>(at - magnitudes.begin() + 1);
  }
  const Query<int> small = from_coordinates(places);
  const auto least =
      std::min_element(symmetries().begin(), symmetries().end(), [&](const Symmetry& x, const Symmetry& y) {
        return coordinates(image(small, x)) < coordinates(image(small, y));
      });
  return coordinates(image(q, *least));
}

std::string text_of(const mpz_class& x) { return x.get_str(16); }

// A number that need not be finite, as its text.
struct Literal {
  std::string text;
  Literal operator-() const {
    if (text == "nan" || text == "0x0p+0") return *this;
    return {text.front() == '-' ? text.substr(1) : "-" + text};
  }
  auto operator<=>(const Literal&) const = default;
};
std::string text_of(const Literal& x) { return x.text; }

template <class Real>
Query<Literal> literals(const Query<Real>& q) {
  std::array<Literal, coordinate_count> out;
  const auto v = coordinates(q);
  for (std::size_t k = 0; k < coordinate_count; ++k) out[k] = {format_number(v[k] == 0 ? Real(0) : v[k])};
  return from_coordinates(out);
}

template <class T>
std::string joined(Precision precision, const std::array<T, coordinate_count>& numbers) {
  std::string text(name(precision));
  for (const T& x : numbers) text += " " + text_of(x);
  return text;
}

}  // namespace

std::string least_image_text(const StoredQuery& stored) {
  return std::visit(
      [&](const auto& q) {
        const auto v = coordinates(q);
        const bool finite = std::all_of(v.begin(), v.end(), [](auto x) { return std::isfinite(x); });
        return finite ? joined(stored.precision, least_image(in_integers(widened(q))))
                      : joined(stored.precision, least_image(literals(q)));
      },
      sphere_triangle_query(stored));
}

namespace {

Query<Rational> in_rationals(const Query<double>& q) {
  std::array<Rational, coordinate_count> exact_numbers;
  const auto v = coordinates(q);
  std::transform(v.begin(), v.end(), exact_numbers.begin(), [](double x) { return exact(x); });
  return from_coordinates(exact_numbers);
}

Rational two_to(int exponent) {
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
std::optional<int> log2_of(const Rational& x) {
  const auto log2 = [](const mpz_class& n) { return static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2)) - 1; };
  const int exponent = log2(x.get_num()) - log2(x.get_den());
  return x == two_to(exponent) ? std::optional(exponent) : std::nullopt;
}

Query<Rational> mapped(const TriangleMap& map, const Query<Rational>& q) {
  auto v = coordinates(image(q, map.symmetry));
  const Rational factor = two_to(map.exponent);
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    v[k] *= factor;
    if (k + 1 < coordinate_count) v[k] += map.by[k % 3];
  }
  return from_coordinates(v);
}

}  // namespace

template <class Real>
std::optional<TriangleMap> map_between(const Query<Real>& base, const Query<Real>& image_of_it) {
  const Query<Rational> from = in_rationals(widened(base)), to = in_rationals(widened(image_of_it));
  const Rational extent = extent_of(from), other = extent_of(to);
  if ((sgn(extent) == 0) != (sgn(other) == 0)) return std::nullopt;
  std::optional<int> exponent = 0;
  if (sgn(extent) != 0) exponent = log2_of(Rational(other / extent));
  if (!exponent) return std::nullopt;
  for (const Symmetry& symmetry : symmetries()) {
    TriangleMap map{symmetry, *exponent, {}};
    const Query<Rational> moved = mapped(map, from);
    map.by = {Rational(to.p.x - moved.p.x), Rational(to.p.y - moved.p.y), Rational(to.p.z - moved.p.z)};
    if (coordinates(mapped(map, from)) == coordinates(to)) return map;
  }
  return std::nullopt;
}
template std::optional<TriangleMap> map_between(const Query<float>&, const Query<float>&);
template std::optional<TriangleMap> map_between(const Query<double>&, const Query<double>&);

template <class Real>
std::optional<Query<Real>> image_by(const TriangleMap& map, const Query<Real>& q) {
  const auto exact_numbers = coordinates(mapped(map, in_rationals(widened(q))));
  std::array<Real, coordinate_count> v;
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    v[k] = nearest<Real>(exact_numbers[k]);
    if (!std::isfinite(v[k]) || exact(v[k]) != exact_numbers[k]) return std::nullopt;
  }
  return from_coordinates(v);
}
template std::optional<Query<float>> image_by(const TriangleMap&, const Query<float>&);
template std::optional<Query<double>> image_by(const TriangleMap&, const Query<double>&);

namespace {

template <class Real>
class MapOfTriangle final : public ImageMap<Real> {
 public:
  explicit MapOfTriangle(const TriangleMap& map)
      : map_(map), of_query_(sphere_triangle_predicate(), map.symmetry.vertices) {}
  std::optional<Numbers<Real>> image(const Numbers<Real>& q) const override {
    const auto found = image_by(map_, query_from(q));
    return found ? std::optional<Numbers<Real>>(*found) : std::nullopt;
  }
  ComparisonBits of_query(ComparisonBits image) const override { return of_query_(image); }

 private:
  TriangleMap map_;
  ComparisonsOfBase of_query_;
};

class MapsOfTriangles final : public ImageMaps {
 public:
  std::unique_ptr<ImageMap<float>> between(const Numbers<float>& query, const Numbers<float>& image) const override {
    return found<float>(query, image);
  }
  std::unique_ptr<ImageMap<double>> between(const Numbers<double>& query, const Numbers<double>& image) const override {
    return found<double>(query, image);
  }

 private:
  template <class Real>
  static std::unique_ptr<ImageMap<Real>> found(const Query<Real>& query, const Query<Real>& image) {
    const auto map = map_between(query, image);
    return map ? std::make_unique<MapOfTriangle<Real>>(*map) : nullptr;
  }
};

}  // namespace

const ImageMaps& sphere_triangle_image_maps() {
  static const MapsOfTriangles maps;
  return maps;
}

}  // namespace axiscert
