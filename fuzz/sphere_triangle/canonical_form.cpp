#include "fuzz/sphere_triangle/canonical_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/numbers/rational.h"
#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"
#include "fuzz/sphere_triangle/families/parts/symmetry.h"
#include "fuzz/text/number_text.h"

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

}  // namespace axiscert
