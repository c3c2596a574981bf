#include "kernel/certified/exact_step.h"

#include <algorithm>
#include <bit>
#include <iterator>

#include "kernel/certified/integer.h"

namespace axiscert::certified {
namespace {

// A double as significand 2^exponent; the last `zeros` bits of the significand are zero.
struct Dyadic {
  std::uint64_t significand;
  int exponent, zeros;
  bool negative;

  explicit Dyadic(double x) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int stored = static_cast<int>((bits >> 52) & 0x7ff), is_normal = stored != 0;
    significand = (bits & ((std::uint64_t{1} << 52) - 1)) | (static_cast<std::uint64_t>(is_normal) << 52);
    exponent = stored - is_normal - 1074;
    zeros = std::countr_zero(significand | (std::uint64_t{1} << 63));
    negative = (bits >> 63) != 0;
  }
  int top() const noexcept { return exponent + static_cast<int>(std::bit_width(significand)); }
};

// Words for the values of each degree of a query whose thirteen numbers are integers below 2^(n - 1) in magnitude: the
// six differences of points stay below 2^n, A.A below 2^(2n + 2), a component of N and V below 2^(2n + 1), d below
// 2^(3n + 3), N.N, N.V and V.V below 2^(4n + 4), degree 6 below 2^(6n + 6); margins below twice that; and a sign.
template <int n>
struct Sizes {
  static constexpr std::size_t words(int bits) { return static_cast<std::size_t>((bits + 63) / 64); }
  static constexpr std::size_t one = words(n + 1), two = words(2 * n + 4), three = words(3 * n + 4),
                               four = words(4 * n + 6), six = words(6 * n + 8);
};

template <std::size_t words>
struct Vector {
  Integer<words> x, y, z;
  friend Vector operator-(const Vector& u, const Vector& v) noexcept { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
  bool is_zero() const noexcept { return x.is_zero() && y.is_zero() && z.is_zero(); }
};
template <std::size_t words, std::size_t m, std::size_t n>
Integer<words> dot(const Vector<m>& u, const Vector<n>& v) noexcept {
  return (product<words>(u.x, v.x) + product<words>(u.y, v.y)) + product<words>(u.z, v.z);
}
template <std::size_t words, std::size_t n>
Vector<words> cross(const Vector<n>& u, const Vector<n>& v) noexcept {
  const auto minor = [](const Integer<n>& a, const Integer<n>& b, const Integer<n>& c, const Integer<n>& d) {
    return product<words>(a, d) - product<words>(b, c);
  };
  return {minor(u.y, u.z, v.y, v.z), minor(u.z, u.x, v.z, v.x), minor(u.x, u.y, v.x, v.y)};
}

// The reduced test (kernel/rungs/reduced.h) with non-strict sides, which decides every triangle; for the open sphere
// with non-strict radii too, of axes that have a normal: the distance is at least r > 0 iff some such axis has all of
// the triangle at distance r or farther (exact/signs.h, is_touching).
template <int bits>
struct Test {
  using N = Sizes<bits>;
  using Point = Vector<N::one>;
  using Normal = Vector<N::two>;
  Point vertex[3];
  Integer<N::two> rr;
  bool open;
  Known known;

  template <std::size_t n>
  bool beyond(const Integer<n>& margin) const noexcept {
    return open ? !margin.is_negative() : margin.is_positive();
  }
  const Point& next(int i) const noexcept { return vertex[i == 2 ? 0 : i + 1]; }
  const Point& last(int i) const noexcept { return vertex[i == 0 ? 2 : i - 1]; }

  bool vertex_separates(int i) const noexcept {
    const int axis = Known::vertex_axis + i;
    const Point& from = vertex[i];
    const auto leads_away = [&](const Point& to) { return !dot<N::two>(from, to - from).is_negative(); };
    return !known.has(Known::fails, axis) && (known.has(Known::radius, axis) || beyond(dot<N::two>(from, from) - rr)) &&
           (known.has(Known::sides, axis) || (leads_away(next(i)) && leads_away(last(i))));
  }
  bool plane_separates(const Normal& V) const noexcept {
    if (known.has(Known::fails, Known::plane_axis) || V.is_zero()) return false;
    const Integer<N::three> d = dot<N::three>(vertex[0], V);
    return beyond(product<N::six>(d, d) - product<N::six>(rr, dot<N::four>(V, V)));
  }
  bool edge_separates(int i, const Normal& V) const noexcept {
    const int axis = Known::edge_axis + i;
    if (known.has(Known::fails, axis)) return false;
    const Point along = next(i) - vertex[i];
    if (along.is_zero()) return false;
    const Normal N_i = cross<N::two>(vertex[i], along);
    return (known.has(Known::sides, axis) || !dot<N::four>(N_i, V).is_positive()) &&
           (known.has(Known::radius, axis) ||
            beyond(dot<N::four>(N_i, N_i) - product<N::four>(rr, dot<N::two>(along, along))));
  }
  // The plane's axis and those of edges whose sides are open need V.
  bool needs_normal() const noexcept {
    constexpr std::uint64_t plane_and_edges = 0b1111 << Known::plane_axis, edges = 0b111 << Known::edge_axis;
    const std::uint64_t fails = known.bits >> Known::fails, sides = known.bits >> Known::sides;
    return (~fails & (plane_and_edges ^ (sides & edges))) & plane_and_edges;
  }
  bool separates() const noexcept {
    for (int i = 0; i < 3; ++i) {
      if (vertex_separates(i)) return true;
    }
    const Normal V = needs_normal() ? cross<N::two>(vertex[1] - vertex[0], vertex[2] - vertex[0]) : Normal{};
    if (plane_separates(V)) return true;
    for (int i = 0; i < 3; ++i) {
      if (edge_separates(i, V)) return true;
    }
    return false;
  }
};

template <int bits>
using Numbers = Integer<Sizes<bits>::one>[13];

template <int bits>
[[gnu::noinline]] bool separated_in(const Numbers<bits>& q, bool open, Known known) noexcept {
  const auto point = [&](int i) { return Vector<Sizes<bits>::one>{q[i], q[i + 1], q[i + 2]}; };
  const auto P = point(9);
  return Test<bits>{{point(0) - P, point(3) - P, point(6) - P}, product<Sizes<bits>::two>(q[12], q[12]), open, known}
      .separates();
}

// The numbers in units of 2^unit.
template <int bits>
[[gnu::noinline]] bool separated_in(const double (&q)[13], int unit, bool open, Known known) noexcept {
  Numbers<bits> numbers;
  for (int i = 0; i < 13; ++i) {
    const Dyadic x(q[i]);
    numbers[i] = shifted<Sizes<bits>::one>(x.significand >> x.zeros, static_cast<unsigned>(x.exponent + x.zeros - unit),
                                           x.negative);
  }
  return separated_in<bits>(numbers, open, known);
}

// The numbers as integers below 2^(bits - 1), if they are that in units of 2^(top - bits + 1), where 2^top is the least
// power of two above all of them. The processor's own conversions, exact where they give the number back.
template <int bits>
bool fit(const double (&q)[13], int top, Numbers<bits>& numbers) noexcept {
  static_assert(bits <= 62);
  const int shift = bits - 1 - top;
  if (shift < -1000 || shift > 1000) return false;
  const auto power = [](int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
  };
  const double scale = power(shift), back = power(-shift);
  for (int i = 0; i < 13; ++i) {
    const auto x = static_cast<std::int64_t>(q[i] * scale);
    if (static_cast<double>(x) * back != q[i]) return false;
    numbers[i].word[0] = static_cast<std::uint64_t>(x);
  }
  return true;
}
int top_of(const double (&q)[13]) noexcept {
  std::uint64_t greatest = 0;
  for (const double x : q) greatest = std::max(greatest, std::bit_cast<std::uint64_t>(x) << 1);
  return static_cast<int>(greatest >> 53) - 1022;
}

// The numbers are multiples of 2^unit, below 2^top in magnitude; zero tells nothing.
struct Span {
  int unit = 1024, top = -1075;
  void include(const Dyadic& x) noexcept {
    if (x.significand == 0) return;
    if (x.exponent + x.zeros < unit) unit = x.exponent + x.zeros;
    if (x.top() > top) top = x.top();
  }
  bool is_empty() const noexcept { return top < unit; }
  int bits() const noexcept { return is_empty() ? 1 : top - unit + 1; }  // n above
};

}  // namespace

bool exactly_separated(const double (&query)[13], Question question, Known known) noexcept {
  bool open = question == Question::open_sphere;
  if (open && query[12] == 0) return true;  // an open sphere of radius 0 is empty
  const int top = top_of(query);
  if (Numbers<30> few_bits; fit<30>(query, top, few_bits)) return separated_in<30>(few_bits, open, known);
  if (Numbers<62> numbers; fit<62>(query, top, numbers)) return separated_in<62>(numbers, open, known);

  Span span;
  for (int i = 0; i < 12; ++i) span.include(Dyadic(query[i]));
  double q[13];
  std::copy(std::begin(query), std::end(query), q);
  const Dyadic r(q[12]);
  if (r.significand != 0 && !span.is_empty() && r.top() <= span.unit - 2 * span.bits() - 2) {
    // A radius so small that rr times 1, |AB|^2 < 2^(2n + 2) or |V|^2 < 2^(4n + 4) is below 1, and the other side of a
    // radius comparison is an integer: beyond iff that is not zero, closed or open. Meshes are asked with the least
    // radius that there is.
    q[12] = 0;
    open = false;
  } else {
    span.include(r);
  }
  const int unit = span.unit, bits = span.bits();
  if (bits <= 30) return separated_in<30>(q, unit, open, known);  // 1, 1, 2, 2 and 3 words
  if (bits <= 40) return separated_in<40>(q, unit, open, known);  // 1, 2, 2, 3, 4
  if (bits <= 62) return separated_in<62>(q, unit, open, known);  // 1, 2, 3, 4, 6
  if (bits <= 94) return separated_in<94>(q, unit, open, known);  // 2, 3, 5, 6, 9
  if (bits <= 126) return separated_in<126>(q, unit, open, known);
  if (bits <= 190) return separated_in<190>(q, unit, open, known);
  if (bits <= 318) return separated_in<318>(q, unit, open, known);  // all of binary32: 128 + 149 + 1
  if (bits <= 702) return separated_in<702>(q, unit, open, known);
  return separated_in<2110>(q, unit, open, known);  // all of binary64: 1024 + 1074 + 1
}

}  // namespace axiscert::certified
