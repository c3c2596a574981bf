// For tests: the judges of a contact that are certain of right answers: floating point of most, integers of the rest.
// The parts are compared by their squared distances, not by the conditions that the library uses.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "exact/numbers/limb_integer.h"
#include "exact/numbers/wide_integer.h"
#include "exact/sphere_triangle/oracles/grid.h"
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
  said.reserve(size);
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
  static constexpr double u = narrow ? 0x1p-24 : 0x1p-53;
  static constexpr double of_separation = narrow ? u : 0, of_scene = (narrow ? 0x1p-13 : 16) * u;
  static constexpr double normal = (narrow ? 1 + 0x1p-9 : 12) * u;
  static constexpr double of_point = u, point_of_scene = (narrow ? 0x1p-12 : 14) * u;
};

template <class Wide>
Wide magnitude_of(Wide x) {
  return x < 0 ? -x : x;
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
  Wide length() const { return std::sqrt(dot(*this, *this)); }
};

inline bool has_sign_of_verdict(bool open, const ContactSaid& said) {
  return (said.verdict == 0) == (open ? said.separation < 0 : said.separation <= 0);
}

// A double or long double is certain of most queries, at a cost of a hundred operations: 2^-37 of the scene is far
// above a double's roundings, 2^-49 above a long double's.
template <class Real>
using FirstJudge = std::conditional_t<sizeof(Real) == 4, double, long double>;

// Whether all is right, where Wide is certain of it. Each quantity is off by less than 64 units of its roundoff times
// the sizes that it is made of; `slack` is 128 units.
template <class Real, class Wide = FirstJudge<Real>>
bool is_surely_right(const std::array<double, 13>& q, bool open, const ContactSaid& said) {
  static_assert(std::numeric_limits<long double>::digits >= 64);
  using Promise = ContactPromise<Real>;
  using Vector = WideVector<Wide>;
  constexpr Wide slack = 64 * std::numeric_limits<Wide>::epsilon();
  constexpr Wide greatest_condition = 0x1p6;
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
    const Wide yy = dot(y, y), t = -dot(b, y) / yy, room = slack * scene / std::sqrt(yy);
    if (!(t > room && t < 1 - room)) return false;
    w = b + y * t;
    if (!(dot(w, v[third] - v[first]) > slack * scene * widest)) return false;
  } else {
    const Vector ab = v[1] - v[0], ac = v[2] - v[0], n = cross(ab, ac), b = v[0] - p;
    // |AB| |AC| / |n|, by which the rounding of n counts.
    const Wide nn = dot(n, n), condition = std::sqrt(dot(ab, ab) * dot(ac, ac) / nn);
    if (!(condition < greatest_condition)) return false;
    error *= condition;
    w = n * (dot(b, n) / nn);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector side = v[(i + 1) % 3] - v[i];
      if (!(dot(cross(side, w - (v[i] - p)), n) > error * side.length() * std::sqrt(nn))) return false;
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

// Vectors of WideInteger or LimbInteger, whose products have as many words as both factors.
template <class Integer>
using IntegerVector = std::array<Integer, 3>;
template <class Integer>
IntegerVector<Integer> operator-(const IntegerVector<Integer>& a, const IntegerVector<Integer>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class A, class B>
auto dot(const IntegerVector<A>& a, const IntegerVector<B>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Integer>
auto cross(const IntegerVector<Integer>& a, const IntegerVector<Integer>& b) {
  return IntegerVector<decltype(a[0] * b[0])>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                              a[0] * b[1] - a[1] * b[0]};
}
template <class Integer>
bool is_less(const Integer& a, const Integer& b) {
  return (a - b).is_negative();
}
template <class Integer>
bool is_positive(const Integer& a) {
  return !a.is_negative() && !a.is_zero();
}

// The magnitude of the number of these words, most significant last, off by at most 2 units of 2^-64: the words below
// the first three that count, and the roundings.
inline long double rounded_words(const std::uint64_t* word, std::size_t size) {
  while (size > 0 && word[size - 1] == 0) --size;
  const std::size_t left_out = size > 3 ? size - 3 : 0;
  long double made = 0;
  for (std::size_t i = size; i-- > left_out;) made = made * 0x1p64L + static_cast<long double>(word[i]);
  return left_out == 0 ? made : std::ldexp(made, static_cast<int>(64 * left_out));
}
template <std::size_t n>
long double rounded(const LimbInteger<n>& a) {
  const long double made = a.as_mpz([](mpz_srcptr x) { return rounded_words(mpz_limbs_read(x), mpz_size(x)); });
  return a.is_negative() ? -made : made;
}
template <std::size_t n>
long double rounded(const WideInteger<n>& a) {
  const auto words =
      std::bit_cast<std::array<std::uint64_t, n>>(a.is_negative() ? WideInteger<n>(std::int64_t{0}) - a : a);
  const long double made = rounded_words(words.data(), n);
  return a.is_negative() ? -made : made;
}
template <class Integer>
WideVector<long double> rounded(const IntegerVector<Integer>& a) {
  return {rounded(a[0]), rounded(a[1]), rounded(a[2])};
}

// x in units of 2^unit.
template <class Integer>
Integer in_units(double x, int unit) {
  const auto stored = magnitude(x);
  if (stored == 0) return Integer(std::int64_t{0});
  const auto bits = significand<double>(stored);
  const int zeros = std::countr_zero(bits);
  const auto odd = static_cast<std::int64_t>(x < 0 ? -(bits >> zeros) : bits >> zeros);
  const int shift = unit_exponent<double>(stored) + zeros - unit;
  if constexpr (std::is_same_v<Integer, WideInteger<1>>) return Integer(odd << shift);
  else if constexpr (std::is_same_v<Integer, WideInteger<2>>) return Integer(static_cast<Int128>(odd) << shift);
  else return Integer::shifted(odd, static_cast<unsigned>(shift));
}

// Whether all is right, with the nearest part and the verdict by integers in units of 2^unit, differences of which fit
// Integer with room for sums: below 2^60 or 2^122 in one word or two, anything in 34. The exact vector to the nearest
// point is a product and a quotient of exact numbers: its components are off by 8 units of 2^-64, its length by 12, its
// direction by 21, and the sums and differences below by few more. `slack` is 128. No number is beyond the range of a
// long double or, where it counts, below: the least square of a distance is 2^-8400 units.
template <class Real, class Integer>
bool is_right_in_units(const std::array<double, 13>& q, int unit, bool open, const ContactSaid& said) {
  using Promise = ContactPromise<Real>;
  using Vector = WideVector<long double>;
  constexpr long double slack = 0x1p-57L, underflow = std::numeric_limits<Real>::denorm_min();
  using Differences = IntegerVector<Integer>;
  const auto at = [&](std::size_t i) -> Differences {
    return {in_units<Integer>(q[i], unit), in_units<Integer>(q[i + 1], unit), in_units<Integer>(q[i + 2], unit)};
  };
  const Differences p = at(9), b[3] = {at(0) - p, at(3) - p, at(6) - p}, y[3] = {b[1] - b[0], b[2] - b[1], b[0] - b[2]};
  const Integer r = in_units<Integer>(q[12], unit);
  const auto rr = r * r;

  // The face if the foot is strictly inside; else the nearest vertex, or an edge whose foot is nearer.
  const auto V = cross(y[0], b[2] - b[0]);
  const auto VV = dot(V, V);
  bool is_inside = !VV.is_zero();
  for (std::size_t i = 0; i < 3 && is_inside; ++i) is_inside = is_positive(dot(cross(b[i], b[(i + 1) % 3]), V));
  std::size_t part = 6;
  Vector w{};
  int order = 0;  // of the distance and r: -1, 0, 1
  bool is_on = false;
  const auto compare = [&](const auto& square, const auto& limit) {
    order = is_less(square, limit) ? -1 : is_less(limit, square) ? 1 : 0;
    is_on = square.is_zero();
  };
  if (is_inside) {
    const auto bV = dot(b[0], V);
    compare(bV * bV, rr * VV);
    w = rounded(V) * (rounded(bV) / rounded(VV));
  } else {
    part = 0;
    auto bb = dot(b[0], b[0]), yy = bb, along = bb;
    auto cc = bb * bb;  // cc / yy is the square of the distance from the edge
    for (std::size_t i = 1; i < 3; ++i) {
      const auto square = dot(b[i], b[i]);
      if (is_less(square, bb)) part = i, bb = square;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto length = dot(y[i], y[i]), t = dot(b[i], b[i] - b[(i + 1) % 3]);
      if (!is_positive(t) || !is_less(t, length)) continue;
      const auto across = cross(b[i], y[i]);
      const auto square = dot(across, across);
      if (part < 3 ? is_less(square, bb * length) : is_less(square * yy, cc * length))
        part = 3 + i, cc = square, yy = length, along = t;
    }
    if (part < 3) {
      compare(bb, rr);
      w = rounded(b[part]);
    } else {
      compare(cc, rr * yy);
      const std::size_t i = part - 3;
      const auto to = [&](std::size_t k) { return rounded(b[i][k] * yy + y[i][k] * along); };
      w = Vector{to(0), to(1), to(2)} * (1 / rounded(yy));
    }
  }
  if (said.feature != static_cast<int>(part) || said.verdict != ((open ? order < 0 : order <= 0) ? 0 : 1) ||
      said.has_normal != (is_on ? 0 : 1) || !has_sign_of_verdict(open, said))
    return false;

  long double scene = q[12];
  const long double scale = std::ldexp(1.0L, unit);
  for (const Differences& each : b) scene = std::max(scene, rounded(each).length() * scale);
  const long double d = w.length(), separation = d * scale - q[12], error = slack * scene;
  if (!(magnitude_of(said.separation - separation) + error <=
        Promise::of_separation * magnitude_of(separation) + Promise::of_scene * scene + underflow))
    return false;
  const Vector centre{q[9], q[10], q[11]}, point_said{said.point[0], said.point[1], said.point[2]},
      normal_said{said.normal[0], said.normal[1], said.normal[2]};
  if (part < 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (said.point[k] != q[3 * part + k]) return false;
    }
  } else {
    // Compared near the centre, from which a point may be nearer than it is to the origin.
    const Vector to_said = point_said - centre, to = w * scale;
    if (!((to_said - to).length() + error <=
          (1 - slack) * Promise::of_point * (centre + to).length() + Promise::point_of_scene * scene + underflow))
      return false;
  }
  Vector normal = normal_said;
  if (!is_on) normal = w * (-1 / d);
  else if (!VV.is_zero()) normal = rounded(V) * (1 / rounded(V).length());
  else {
    if (!(magnitude_of(normal.length() - 1) + slack <= Promise::normal)) return false;
    for (const Differences& edge : y) {
      const Vector way = rounded(edge);
      if (!(magnitude_of(dot(way, normal)) + slack * way.length() <= Promise::normal * way.length())) return false;
    }
  }
  return (normal_said - normal).length() + slack <= Promise::normal;
}

template <class Real>
bool is_right_by_integers(const std::array<double, 13>& q, bool open, const ContactSaid& said) {
  const int unit = least_set_bit(q);
  double greatest = 0;
  for (const double x : q) greatest = std::max(greatest, std::abs(x));
  // Differences are below 2^bits units.
  const int bits = greatest == 0 ? 0 : std::ilogb(greatest) + 2 - unit;
  if (bits <= 60) return is_right_in_units<Real, WideInteger<1>>(q, unit, open, said);
  if (bits <= 122) return is_right_in_units<Real, WideInteger<2>>(q, unit, open, said);
  return is_right_in_units<Real, LimbInteger<34>>(q, unit, open, said);
}

}  // namespace axiscert::testing_support
