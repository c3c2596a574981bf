// For tests: what is wrong with the numbers of a contact, if anything. In long double, or in 113 bits, where these are
// certain, by integers and MPFR elsewhere; the parts are compared by their squared distances, not by the conditions
// that the library uses.
#pragma once

#include <gmpxx.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "kernel/include/axiscert/contact.hpp"

namespace axiscert::testing_support {

// The library's answer to one query.
struct ContactSaid {
  int verdict, feature, has_normal;
  double separation;
  std::array<double, 3> normal, point;
};

// The library's answers to `size` queries, which are columns of their 13 numbers.
template <class Real>
std::vector<ContactSaid> contacts_said(const std::array<const Real*, 13>& columns, std::size_t size,
                                       axiscert_question question) {
  std::vector<std::uint8_t> verdict(size), feature(size), has_normal(size);
  std::array<std::vector<Real>, 7> n;
  for (auto& column : n) column.resize(size);
  certified::contact_pairs(columns, size, question,
                           {verdict.data(),
                            feature.data(),
                            has_normal.data(),
                            n[0].data(),
                            {n[1].data(), n[2].data(), n[3].data()},
                            {n[4].data(), n[5].data(), n[6].data()}});
  std::vector<ContactSaid> said;
  for (std::size_t i = 0; i < size; ++i) {
    said.push_back(
        {verdict[i], feature[i], has_normal[i], n[0][i], {n[1][i], n[2][i], n[3][i]}, {n[4][i], n[5][i], n[6][i]}});
  }
  return said;
}

// The bounds of kernel/include/axiscert/contact.h.
template <class Real>
struct ContactPromise {
  static constexpr bool narrow = sizeof(Real) == 4;
  static constexpr double u = narrow ? 0x1p-24 : 0x1p-53, half = narrow ? 0x1p-150 : 0;  // half of the least number
  static constexpr double of_separation = narrow ? u : 0, of_scene = (narrow ? 0x1p-13 : 16) * u;
  static constexpr double normal = (narrow ? 1 + 0x1p-9 : 12) * u;
  static constexpr double of_point = u, point_of_scene = (narrow ? 0x1p-12 : 14) * u;
};

// What a query is judged in before integers are asked.
template <class Wide>
inline constexpr int bits_of_wide = std::is_same_v<Wide, long double> ? 64 : 113;
using Widest = __float128;

template <class Wide>
Wide magnitude_of(Wide x) {
  return x < 0 ? -x : x;
}
template <class Wide>
Wide root_of(Wide x) {
  const long double near = std::sqrt(static_cast<long double>(x));
  if constexpr (std::is_same_v<Wide, long double>) return near;
  else return near > 0 ? (near + x / near) / 2 : Wide(near);
}

template <class Wide>
struct WideVector {
  Wide x, y, z;
  friend WideVector operator-(const WideVector& a, const WideVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend WideVector operator+(const WideVector& a, const WideVector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend WideVector operator*(const WideVector& a, Wide s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Wide dot(const WideVector& a, const WideVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend WideVector cross(const WideVector& a, const WideVector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  Wide length() const { return root_of(dot(*this, *this)); }
};

inline bool has_sign_of_verdict(bool open, const ContactSaid& said) {
  return (said.verdict == 0) == (open ? said.separation < 0 : said.separation <= 0);
}

// Whether all is right, where Wide is certain of it. Each quantity is off by less than 64 units of its roundoff times
// the sizes that it is made of; `slack` is 128 units.
template <class Real, class Wide>
bool is_surely_right(const std::array<double, 13>& q, bool open, const ContactSaid& said) {
  static_assert(std::numeric_limits<long double>::digits >= 64);
  using Promise = ContactPromise<Real>;
  using Vector = WideVector<Wide>;
  constexpr Wide slack = bits_of_wide<Wide> == 64 ? Wide(0x1p-57L) : Wide(0x1p-106L);
  constexpr Wide greatest_condition = bits_of_wide<Wide> == 64 ? 0x1p6 : 0x1p40;
  const auto at = [&](std::size_t i) { return Vector{q[3 * i], q[3 * i + 1], q[3 * i + 2]}; };
  const Vector v[3] = {at(0), at(1), at(2)}, p = at(3);
  const Wide r = q[12];
  if (!(r >= 0) || said.feature < 0 || said.feature > 6 || said.has_normal != 1) return false;
  Wide scene = r, widest = 0;
  for (int i = 0; i < 3; ++i) {
    scene = std::max(scene, (v[i] - p).length());
    widest = std::max(widest, (v[(i + 1) % 3] - v[i]).length());
  }
  if (!(scene > Wide(0x1p-900) && scene < Wide(std::numeric_limits<double>::max()))) return false;
  const std::size_t f = static_cast<std::size_t>(said.feature), first = f % 3, second = (f + 1) % 3,
                    third = (f + 2) % 3;
  Vector w{};  // from the centre to the nearest point
  Wide error = slack * scene;
  if (f < 3) {
    w = v[f] - p;
    const Wide margin = slack * scene * widest;
    if (!(dot(w, v[second] - v[f]) > margin && dot(w, v[third] - v[f]) > margin)) return false;
  } else if (f < 6) {
    const Vector b = v[first] - p, y = v[second] - v[first];
    const Wide yy = dot(y, y), t = -dot(b, y) / yy, room = slack * scene / root_of(yy);
    if (!(t > room && t < 1 - room)) return false;
    w = b + y * t;
    if (!(dot(w, v[third] - v[first]) > slack * scene * widest)) return false;
  } else {
    const Vector ab = v[1] - v[0], ac = v[2] - v[0], n = cross(ab, ac), b = v[0] - p;
    // |AB| |AC| / |n|, by which the rounding of n counts.
    const Wide nn = dot(n, n), condition = root_of(dot(ab, ab) * dot(ac, ac) / nn);
    if (!(condition < greatest_condition)) return false;
    error *= condition;
    w = n * (dot(b, n) / nn);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector side = v[(i + 1) % 3] - v[i];
      if (!(dot(cross(side, w - (v[i] - p)), n) > error * side.length() * root_of(nn))) return false;
    }
  }
  const Wide d = w.length(), separation = d - r;
  if (!(d > 0) || !(magnitude_of<Wide>(separation) > error) || (said.verdict == 0) != (separation < 0)) return false;
  if (!has_sign_of_verdict(open, said)) return false;
  if (!(magnitude_of<Wide>(said.separation - separation) + error <=
        Promise::of_separation * magnitude_of<Wide>(separation) + Promise::of_scene * scene))
    return false;
  const Vector normal = w * (-1 / d), point = f < 3 ? v[f] : p + w;
  const Vector normal_said{said.normal[0], said.normal[1], said.normal[2]},
      point_said{said.point[0], said.point[1], said.point[2]};
  const Wide point_error = f < 3 ? 0 : error + slack * point.length();
  return (normal_said - normal).length() + 2 * error / d <= Promise::normal &&
         (point_said - point).length() + point_error <=
             (f < 3 ? 0 : Promise::of_point * point.length() + Promise::point_of_scene * scene);
}

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
  const double least = std::numeric_limits<Real>::denorm_min() / 2.0, underflow = 2 * std::max(least, 0x1p-1074);
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

// The first thing that is wrong; empty where nothing is. `is_exact` is set where integers and MPFR were asked.
template <class Real>
std::string what_is_wrong(const std::array<double, 13>& q, bool open, const ContactSaid& said,
                          bool* is_exact = nullptr) {
  bool is_valid = q[12] >= 0;
  for (const double x : q) is_valid = is_valid && std::isfinite(x);
  if (!is_valid) {
    const bool is_nothing = std::isnan(said.separation) && std::isnan(said.normal[0]) && std::isnan(said.normal[1]) &&
                            std::isnan(said.normal[2]) && std::isnan(said.point[0]) && std::isnan(said.point[1]) &&
                            std::isnan(said.point[2]) && said.feature == 7 && said.has_normal == 0;
    return said.verdict == 3 && is_nothing ? "" : "an answer about what is no query";
  }
  if (is_surely_right<Real, long double>(q, open, said) || is_surely_right<Real, Widest>(q, open, said)) return {};
  if (is_exact != nullptr) *is_exact = true;
  return exactly_wrong<Real>(q, open, said);
}

}  // namespace axiscert::testing_support
