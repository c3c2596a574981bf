// For tests: what is wrong with the numbers of a contact, if anything. Where neither floating point nor integers
// confirm an answer, MPFR says what is wrong.
#pragma once

#include <gmpxx.h>
#include <mpfr.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "exact/sphere_triangle/certified_contact_judges.h"
#include "exact/sphere_triangle/measures/nearest_place.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert::testing_support {

// A number of 320 bits.
class Mpfr {
 public:
  Mpfr() { mpfr_init2(x_, 320); }
  Mpfr(const Mpfr& other) : Mpfr() { mpfr_set(x_, other.x_, MPFR_RNDN); }
  explicit Mpfr(double x) : Mpfr() { mpfr_set_d(x_, x, MPFR_RNDN); }
  explicit Mpfr(const mpz_class& x) : Mpfr() { mpfr_set_z(x_, x.get_mpz_t(), MPFR_RNDN); }
  ~Mpfr() { mpfr_clear(x_); }
  Mpfr& operator=(const Mpfr& other) {
    mpfr_set(x_, other.x_, MPFR_RNDN);
    return *this;
  }
  friend Mpfr operator+(const Mpfr& a, const Mpfr& b) { return of(mpfr_add, a, b); }
  friend Mpfr operator-(const Mpfr& a, const Mpfr& b) { return of(mpfr_sub, a, b); }
  friend Mpfr operator*(const Mpfr& a, const Mpfr& b) { return of(mpfr_mul, a, b); }
  friend Mpfr operator/(const Mpfr& a, const Mpfr& b) { return of(mpfr_div, a, b); }
  friend bool operator<=(const Mpfr& a, const Mpfr& b) { return mpfr_lessequal_p(a.x_, b.x_) != 0; }
  Mpfr root() const {
    Mpfr made;
    mpfr_sqrt(made.x_, x_, MPFR_RNDN);
    return made;
  }
  Mpfr magnitude() const {
    Mpfr made;
    mpfr_abs(made.x_, x_, MPFR_RNDN);
    return made;
  }
  // Times 2^e.
  Mpfr shifted(long e) const {
    Mpfr made;
    mpfr_mul_2si(made.x_, x_, e, MPFR_RNDN);
    return made;
  }
  double to_double() const { return mpfr_get_d(x_, MPFR_RNDN); }

 private:
  template <class Function>
  static Mpfr of(Function function, const Mpfr& a, const Mpfr& b) {
    Mpfr made;
    function(made.x_, a.x_, b.x_, MPFR_RNDN);
    return made;
  }
  mpfr_t x_;
};

using WholeVector = std::array<mpz_class, 3>;
inline WholeVector minus(const WholeVector& a, const WholeVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline WholeVector times(const WholeVector& a, const mpz_class& s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline WholeVector plus(const WholeVector& a, const WholeVector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline mpz_class product(const WholeVector& a, const WholeVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline WholeVector cross_product(const WholeVector& a, const WholeVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline std::array<Mpfr, 3> rounded(const WholeVector& v) { return {Mpfr(v[0]), Mpfr(v[1]), Mpfr(v[2])}; }
inline Mpfr length(const std::array<Mpfr, 3>& v) { return (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).root(); }

// The first thing that is wrong; empty where nothing is. The query is finite with r >= 0.
template <class Real>
std::string exactly_wrong(const std::array<double, 13>& q, bool open, const ContactSaid& said) {
  using Promise = ContactPromise<Real>;
  int unit = 1100;
  for (const double x : q) {
    if (x != 0) unit = std::min(unit, std::ilogb(x) - 52);
  }
  if (unit == 1100) unit = 0;
  const auto whole = [&](double x) {
    int e = 0;
    const double m = std::ldexp(std::frexp(x, &e), 53);
    mpz_class made(m);
    const int by = e - 53 - unit;
    if (by >= 0) made <<= static_cast<unsigned>(by);
    else made >>= static_cast<unsigned>(-by);  // the last bits are zero
    return x == 0 ? mpz_class(0) : made;
  };
  WholeVector v[3], p;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) v[i][k] = whole(q[3 * i + k]);
    p[k] = whole(q[9 + k]);
  }
  const mpz_class r = whole(q[12]);

  // The nearest point of each part that is not one of its ends, as the vector from the centre: numerator, denominator.
  struct Candidate {
    bool is_there = false;
    WholeVector w;
    mpz_class by;
    mpz_class square() const { return product(w, w); }
  };
  std::array<Candidate, 7> all;
  for (std::size_t i = 0; i < 3; ++i) {
    const WholeVector b = minus(v[i], p), y = minus(v[(i + 1) % 3], v[i]);
    all[i] = {true, b, 1};
    const mpz_class yy = product(y, y), t = -product(b, y);
    if (t > 0 && t < yy) all[3 + i] = {true, plus(times(b, yy), times(y, t)), yy};
  }
  const WholeVector V = cross_product(minus(v[1], v[0]), minus(v[2], v[0]));
  const mpz_class VV = product(V, V);
  bool is_inside = VV != 0;
  for (std::size_t i = 0; i < 3; ++i) {
    is_inside = is_inside && product(cross_product(minus(v[(i + 1) % 3], v[i]), minus(p, v[i])), V) > 0;
  }
  if (is_inside) all[6] = {true, times(V, product(minus(v[0], p), V)), VV};
  std::size_t best = 7;
  for (std::size_t i = 0; i < 7; ++i) {
    if (!all[i].is_there) continue;
    // |w| / by < |w'| / by'
    if (best == 7 || all[i].square() * all[best].by * all[best].by < all[best].square() * all[i].by * all[i].by)
      best = i;
  }
  if (said.feature != static_cast<int>(best))
    return "feature " + std::to_string(said.feature) + ", not " + std::to_string(best);
  const Candidate& nearest = all[best];
  const mpz_class square = nearest.square(), limit = r * r * nearest.by * nearest.by;
  const bool contact = open ? square < limit : square <= limit;
  if (said.verdict != (contact ? 0 : 1)) return "verdict " + std::to_string(said.verdict);
  if (said.has_normal != (square != 0 ? 1 : 0)) return "has_normal " + std::to_string(said.has_normal);

  if (!has_sign_of_verdict(open, said)) return "separation " + std::to_string(said.separation) + " beside its verdict";

  const auto with_unit = [unit](const Mpfr& x) { return x.shifted(unit); };
  Mpfr scene(r);
  for (std::size_t i = 0; i < 3; ++i) {
    const Mpfr size = length(rounded(minus(v[i], p)));
    if (scene <= size) scene = size;
  }
  scene = with_unit(scene);
  const std::array<Mpfr, 3> w = rounded(nearest.w);
  const Mpfr by(nearest.by), size = length(w), d = with_unit(size / by), separation = d - Mpfr(q[12]);
  const double underflow = std::numeric_limits<Real>::denorm_min();
  const Mpfr allowed = Mpfr(Promise::of_separation) * separation.magnitude() + Mpfr(Promise::of_scene) * scene;
  if (std::isinf(said.separation)) {
    if (!(Mpfr(double{std::numeric_limits<Real>::max()}) <= separation + allowed)) return "infinite separation";
  } else if (!((separation - Mpfr(said.separation)).magnitude() <= allowed + Mpfr(underflow))) {
    return "separation " + std::to_string(said.separation) + ", not " + std::to_string(separation.to_double());
  }
  std::array<Mpfr, 3> off;
  for (std::size_t k = 0; k < 3; ++k) {
    const Mpfr point = best < 3 ? Mpfr(q[3 * best + k]) : Mpfr(q[9 + k]) + with_unit(w[k] / by);
    off[k] = point - Mpfr(said.point[k]);
  }
  std::array<Mpfr, 3> point;
  for (std::size_t k = 0; k < 3; ++k) point[k] = off[k] + Mpfr(said.point[k]);
  const Mpfr of_point =
      Mpfr(Promise::of_point) * length(point) + Mpfr(Promise::point_of_scene) * scene + Mpfr(underflow);
  if (!(length(off) <= (best < 3 ? Mpfr(0.0) : of_point)))
    return "point off by " + std::to_string(length(off).to_double());

  std::array<Mpfr, 3> normal;
  const Mpfr size_of_v = length(rounded(V));
  if (square != 0) {
    for (std::size_t k = 0; k < 3; ++k) normal[k] = Mpfr(-1.0) * w[k] / size;
  } else if (VV != 0) {
    for (std::size_t k = 0; k < 3; ++k) normal[k] = Mpfr(V[k]) / size_of_v;
  } else {
    for (std::size_t k = 0; k < 3; ++k) normal[k] = Mpfr(said.normal[k]);
    const Mpfr unit_length = length(normal);
    if (!((unit_length - Mpfr(1.0)).magnitude() <= Mpfr(Promise::normal))) return "a chosen normal without length 1";
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<Mpfr, 3> y = rounded(minus(v[(i + 1) % 3], v[i]));
      const Mpfr along = y[0] * normal[0] + y[1] * normal[1] + y[2] * normal[2];
      if (!(along.magnitude() <= Mpfr(Promise::normal) * length(y))) return "a chosen normal along an edge";
    }
  }
  for (std::size_t k = 0; k < 3; ++k) off[k] = normal[k] - Mpfr(said.normal[k]);
  if (!(length(off) <= Mpfr(Promise::normal + underflow)))
    return "normal off by " + std::to_string(length(off).to_double());
  return {};
}

// The first thing that is wrong; empty where nothing is. `judge` is set to 0, 1 or 2: floating point, integers, MPFR.
template <class Real>
std::string what_is_wrong(const std::array<double, 13>& q, bool open, const ContactSaid& said, int* judge = nullptr) {
  bool is_valid = q[12] >= 0;
  for (const double x : q) is_valid = is_valid && std::isfinite(x);
  if (!is_valid) {
    const bool is_nothing = std::isnan(said.separation) && std::isnan(said.normal[0]) && std::isnan(said.normal[1]) &&
                            std::isnan(said.normal[2]) && std::isnan(said.point[0]) && std::isnan(said.point[1]) &&
                            std::isnan(said.point[2]) && said.feature == 7 && said.has_normal == 0;
    return said.verdict == 3 && is_nothing ? "" : "an answer about what is no query";
  }
  int ignored = 0;
  int& by = judge != nullptr ? *judge : ignored;
  by = 0;
  if (is_surely_right<Real>(q, open, said)) return {};
  by = 1;
  if (is_right_by_integers<Real>(q, open, said)) return {};
  by = 2;
  return exactly_wrong<Real>(q, open, said);
}

// The fault of feature and verdict, by the rationals and CGAL by which the judge goes; empty: nothing.
inline std::string what_is_wrong_for_the_judge(const std::array<double, 13>& q, const ContactSaid& said) {
  static constexpr std::array parts = {Axis::vertex_a, Axis::vertex_b, Axis::vertex_c,
                                       Axis::edge_ab,  Axis::edge_bc,  Axis::edge_ca};
  const bool is_query = q[12] >= 0 && std::ranges::all_of(q, [](double x) { return std::isfinite(x); });
  if (!is_query) return said.verdict == AXISCERT_INVALID ? "" : "an answer about what is no query";
  const NearestPlace place = nearest_place(from_coordinates(q));
  const auto part = static_cast<std::size_t>(said.feature);
  const std::string_view name = part < parts.size()     ? axis_names[parts[part]]
                                : part == AXISCERT_FACE ? std::string_view("face")
                                                        : std::string_view("none");
  if (place.features.front() != name)
    return "feature " + std::to_string(said.feature) + ", not " + std::string(place.features.front());
  const Rational r(q[12]);
  const bool is_contact = place.squared_distance <= r * r;
  return (said.verdict == AXISCERT_CONTACT) == is_contact ? "" : "verdict " + std::to_string(said.verdict);
}

}  // namespace axiscert::testing_support
