// Errors, with v = 2^-53, beside contact_steps.h: the components of b, y, N, V and b.V are exact integers rounded once,
// by 1.13 v at most. So |w| of a vertex is off by 3.6 v d, of an edge by (2.83 + 1.1 + 1.1 + 5.2 + 2) v d and the
// root's 2.5 v, of the face by (3 + 2.2 + 1.1 + 1.1 + 3) v d and these: each below what the first step is allowed, and
// relative to d. Powers of two scale every vector to a greatest component of [1/2, 1); what underflows then is below
// 2^-500 of it.
#include "kernel/sphere_triangle/certified/exact_contact.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "kernel/sphere_triangle/certified/exact_margins.h"
#include "kernel/sphere_triangle/certified/exact_step.h"
#include "kernel/sphere_triangle/certified/widths.h"

namespace axiscert::certified {
namespace {

constexpr int face = 6, no_feature = 7;

// m 2^e; |m| is in [1/2, 1), or m is 0.
struct Scaled {
  double m;
  int e;
};
Scaled scaled(double m, int e) noexcept {
  int by = 0;
  const double at = std::frexp(m, &by);
  return {at, at == 0 ? 0 : e + by};
}

// The integer, rounded by at most 2^-53 + 2^-64 of it.
template <std::size_t words>
Scaled rounded(const Integer<words>& x) noexcept {
  const Integer<words> magnitude = x.is_negative() ? Integer<words>{} - x : x;
  std::size_t top = words - 1;
  while (top > 0 && magnitude.word[top] == 0) --top;
  UInt128 leading = magnitude.word[top];
  if (top > 0) leading = (leading << 64) | magnitude.word[top - 1];
  const double m = static_cast<double>(leading);
  return scaled(x.is_negative() ? -m : m, top > 0 ? 64 * static_cast<int>(top - 1) : 0);
}
// The digits in units of the least double to the power of their degree.
template <int degree>
Scaled rounded(const BalancedDigits<degree>& x) noexcept {
  if (x.is_zero()) return {0, 0};
  const int last = x.size - 1, bits = x.base_bits, below = int{x.place[last]} - 1;
  Int128 leading = Int128{x.digit[last]} << bits;
  if (last > 0 && x.place[last - 1] == below) leading += x.digit[last - 1];
  return scaled(static_cast<double>(leading), bits * below - 1074 * degree);
}

// (x, y, z) 2^e with a greatest component of [1/2, 1), or the zero vector.
struct ScaledVector {
  double x, y, z;
  int e;
  bool is_zero() const noexcept { return x == 0 && y == 0 && z == 0; }
};
ScaledVector vector_of(const Scaled& x, const Scaled& y, const Scaled& z) noexcept {
  int e = std::numeric_limits<int>::min();
  for (const Scaled& i : {x, y, z}) {
    if (i.m != 0) e = std::max(e, i.e);
  }
  if (e == std::numeric_limits<int>::min()) return {0, 0, 0, 0};
  const auto at = [e](const Scaled& i) { return i.m == 0 ? 0 : std::ldexp(i.m, std::max(i.e - e, -1100)); };
  return {at(x), at(y), at(z), e};
}
// `unit` is the exponent of the unit of the vector's degree.
template <class Number>
ScaledVector rounded(const Vector<Number>& v, int unit) noexcept {
  ScaledVector made = vector_of(rounded(v.x), rounded(v.y), rounded(v.z));
  made.e += unit;
  return made;
}
double dot(const ScaledVector& u, const ScaledVector& v) noexcept { return (u.x * v.x + u.y * v.y) + u.z * v.z; }
ScaledVector times(const ScaledVector& v, const Scaled& by) noexcept {
  return vector_of(scaled(v.x * by.m, v.e + by.e), scaled(v.y * by.m, v.e + by.e), scaled(v.z * by.m, v.e + by.e));
}
ScaledVector cross(const ScaledVector& u, const ScaledVector& v) noexcept {
  const int e = u.e + v.e;
  return vector_of(scaled(u.y * v.z - u.z * v.y, e), scaled(u.z * v.x - u.x * v.z, e),
                   scaled(u.x * v.y - u.y * v.x, e));
}

struct Place {
  int feature;
  ScaledVector from_centre;  // from the centre to the nearest point; zero if they are one point
  ScaledVector normal;       // of the face, zero without area
  ScaledVector along;        // the longest edge, for triangles without area
};

template <class Numbers>
class Nearest {
 public:
  // `unit` is the exponent of the unit of the numbers.
  Nearest(const Query13<Numbers>& q, int unit) noexcept : m_(q), unit_(unit) {}

  [[gnu::noinline]] Place find() const noexcept {
    const Normal V = m_.plane_normal();
    for (int i = 0; i < 3; ++i) {
      if (!m_.vertex_side(i, m_.next(i)).is_negative() && !m_.vertex_side(i, m_.last(i)).is_negative())
        return at(i, rounded(m_.from_centre(i), unit_), V);
    }
    for (int i = 0; i < 3; ++i) {
      const int next = m_.next(i);
      if (!m_.vertex_side(i, next).is_negative() || !m_.vertex_side(next, i).is_negative()) continue;
      const Point along = m_.along(i);
      const Normal N = m_.edge_normal(i, along);
      if (m_.edge_side(N, V).is_positive()) continue;
      const ScaledVector y = rounded(along, unit_), n = rounded(N, 2 * unit_);
      return at(3 + i, n.is_zero() ? n : times(cross(y, n), inverse(dot(y, y), 2 * y.e)), V);
    }
    Scaled offset = rounded(m_.plane_offset(V));
    offset.e += 3 * unit_;
    const ScaledVector n = rounded(V, 2 * unit_);
    const Scaled by = inverse(dot(n, n), 2 * n.e);
    return at(face, offset.m == 0 ? ScaledVector{} : times(n, scaled(offset.m * by.m, offset.e + by.e)), V);
  }

 private:
  using Margins = ExactMargins<Numbers>;
  using Point = typename Margins::Point;
  using Normal = typename Margins::Normal;

  static Scaled inverse(double x, int e) noexcept { return scaled(1 / x, -e); }
  Place at(int feature, const ScaledVector& from_centre, const Normal& V) const noexcept {
    Place found{feature, from_centre, {}, {}};
    if (!from_centre.is_zero()) return found;
    found.normal = rounded(V, 2 * unit_);
    for (int i = 0; i < 3; ++i) {
      const ScaledVector along = rounded(m_.along(i), unit_);
      if (!along.is_zero() && (found.along.is_zero() || along.e > found.along.e)) found.along = along;
    }
    return found;
  }

  Margins m_;
  int unit_;
};
template <class Numbers>
Place nearest_in(const Query13<Numbers>& q, int unit) noexcept {
  return Nearest<Numbers>(q, unit).find();
}

// The radius does not count: it is no part of what is nearest.
Place nearest(const double (&query)[13]) noexcept {
  double q[13];
  std::copy_n(query, 12, q);
  q[12] = 0;
  bool unused = false;
  const int top = top_of(q);
  if (Query13<Integers<30>> numbers; fit<30>(q, top, numbers, unused))
    return nearest_in<Integers<30>>(numbers, top - 29);
  if (Query13<Integers<62>> numbers; fit<62>(q, top, numbers, unused))
    return nearest_in<Integers<62>>(numbers, top - 61);
  Span span;
  for (int i = 0; i < 12; ++i) span.include(Dyadic(q[i]));
  if (span.bits() <= 94) {
    Query13<Integers<94>> numbers;
    convert<94>(q, span.unit, numbers);
    return nearest_in<Integers<94>>(numbers, span.unit);
  }
  if (span.bits() <= 126) {
    Query13<Integers<126>> numbers;
    convert<126>(q, span.unit, numbers);
    return nearest_in<Integers<126>>(numbers, span.unit);
  }
  Query13<Digits> numbers;
  convert(q, numbers);
  return nearest_in<Digits>(numbers, 0);
}

// x + y 2^e, without overflow on the way.
double sum(double x, double y, int e) noexcept {
  constexpr int down = 64, high = 900;
  if (e < high && std::fabs(x) < 0x1p900) return x + std::ldexp(y, e);
  return std::ldexp(std::ldexp(x, -down) + std::ldexp(y, e - down), down);
}

// A unit vector where the centre is on the triangle: the face's normal; without area, across the longest edge; z where
// the triangle is a point.
ScaledVector chosen_normal(const Place& place) noexcept {
  if (!place.normal.is_zero()) return place.normal;
  const ScaledVector& y = place.along;
  if (y.is_zero()) return {0, 0, 1, 0};
  const double x = std::fabs(y.x), z = std::fabs(y.z), least = std::min({x, std::fabs(y.y), z});
  return least == z   ? ScaledVector{y.y, -y.x, 0, 0}
         : least == x ? ScaledVector{0, y.z, -y.y, 0}
                      : ScaledVector{-y.z, 0, y.x, 0};
}

template <class Real>
void write_normal(const ScaledVector& n, double sign, std::size_t i, const ContactColumns<Real>& to) noexcept {
  const double by = sign / std::sqrt(dot(n, n));
  to.normal[0][i] = static_cast<Real>(n.x * by + 0.0);
  to.normal[1][i] = static_cast<Real>(n.y * by + 0.0);
  to.normal[2][i] = static_cast<Real>(n.z * by + 0.0);  // no -0
}

// The separation, or the nearest to it that has the verdict's sign: of contact with the closed sphere at most 0, with
// the open one below it.
template <class Real>
Real agreeing(Real separation, bool contact, Question question) noexcept {
  constexpr Real least = std::numeric_limits<Real>::denorm_min();
  const bool is_open = question == Question::open_sphere;
  return contact ? std::min(separation, is_open ? -least : Real(0)) : std::max(separation, is_open ? Real(0) : least);
}

}  // namespace

template <class Real>
void settle_verdicts(const Block<Real>& block, const std::uint16_t* index, std::size_t count, Question question,
                     const ContactColumns<Real>& to, BlockContacts& answer) noexcept {
  Real column[13][block_size];
  Block<Real> packed{{}, count, block.one_sphere};
  for (std::size_t k = 0; k < 13; ++k) {
    const bool is_one = block.one_sphere && k >= 9;
    packed.column[k] = is_one ? block.column[k] : column[k];
    for (std::size_t j = 0; j < count && !is_one; ++j) column[k][j] = block.column[k][index[j]];
  }
  BlockAnswer found;
  chosen_forms().block<Real>()(packed, question, found);
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t i = index[j];
    const bool contact = has_bit(found.contact[j / 64], j % 64);
    answer.contact[i / 64] |= std::uint64_t{contact} << (i % 64);
    to.separation[i] = agreeing(to.separation[i], contact, question);
  }
}
template void settle_verdicts<float>(const Block<float>&, const std::uint16_t*, std::size_t, Question,
                                     const ContactColumns<float>&, BlockContacts&) noexcept;
template void settle_verdicts<double>(const Block<double>&, const std::uint16_t*, std::size_t, Question,
                                      const ContactColumns<double>&, BlockContacts&) noexcept;

template <class Real>
void settle_contact(const double (&q)[13], Question question, std::size_t i, const ContactColumns<Real>& to,
                    BlockContacts& answer) noexcept {
  const std::uint64_t bit = std::uint64_t{1} << (i % 64);
  const auto note_feature = [&](int feature) {
    for (int k = 0; k < 3; ++k) {
      if ((feature >> k) & 1) answer.feature[k][i / 64] |= bit;
    }
  };
  bool is_valid = q[12] >= 0;
  for (const double x : q) is_valid &= std::isfinite(x);
  if (!is_valid) {
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    answer.invalid[i / 64] |= bit;
    answer.no_normal[i / 64] |= bit;
    note_feature(no_feature);
    to.separation[i] = nan;
    for (int k = 0; k < 3; ++k) to.normal[k][i] = to.point[k][i] = nan;
    return;
  }
  const bool contact = !exactly_separated(q, question, {});
  if (contact) answer.contact[i / 64] |= bit;

  const Place place = nearest(q);
  note_feature(place.feature);
  const ScaledVector& w = place.from_centre;
  if (w.is_zero()) {
    answer.no_normal[i / 64] |= bit;
    to.separation[i] = static_cast<Real>(0 - q[12]);
    write_normal(chosen_normal(place), 1, i, to);
  } else {
    to.separation[i] = static_cast<Real>(sum(-q[12], std::sqrt(dot(w, w)), w.e));
    write_normal(w, -1, i, to);
  }
  to.separation[i] = agreeing(to.separation[i], contact, question);
  const double from_centre[3] = {w.x, w.y, w.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = q[k], b = q[3 + k], c = q[6 + k], p = q[9 + k];
    // The nearest point is between the vertices, and so is its rounding.
    const double at = place.feature < 3 ? q[3 * static_cast<std::size_t>(place.feature) + k]
                      : w.is_zero()     ? p
                                    : std::clamp(sum(p, from_centre[k], w.e), std::min({a, b, c}), std::max({a, b, c}));
    to.point[k][i] = static_cast<Real>(at);
  }
}
template void settle_contact<float>(const double (&)[13], Question, std::size_t, const ContactColumns<float>&,
                                    BlockContacts&) noexcept;
template void settle_contact<double>(const double (&)[13], Question, std::size_t, const ContactColumns<double>&,
                                     BlockContacts&) noexcept;

namespace {
template <class Real>
void decide_exactly(const Block<Real>& block, Question question, const ContactColumns<Real>& to,
                    BlockContacts& answer) noexcept {
  answer = {};
  for (std::size_t i = 0; i < block.size; ++i) {
    double q[13];
    for (std::size_t k = 0; k < 13; ++k)
      q[k] = static_cast<double>(block.column[k][k >= 9 && block.one_sphere ? 0 : i]);
    settle_contact(q, question, i, to, answer);
  }
}
}  // namespace

const ContactForms& exact_contact_forms() noexcept {
  static constexpr ContactForms forms = {decide_exactly<float>, decide_exactly<double>, decide_exactly<float>,
                                         decide_exactly<double>};
  return forms;
}

}  // namespace axiscert::certified
