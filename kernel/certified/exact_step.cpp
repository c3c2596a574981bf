#include "kernel/certified/exact_step.h"

#include <bit>

#include "kernel/certified/integer.h"

namespace axiscert::certified {
namespace {

// A double that is not zero as significand 2^exponent, its significand odd.
struct Dyadic {
  std::uint64_t significand;
  int exponent;
  bool negative;
};

Dyadic dyadic(double x) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int stored = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t significand = stored == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
  const int zeros = significand == 0 ? 0 : std::countr_zero(significand);
  return {significand >> zeros, (stored == 0 ? 1 : stored) - 1075 + zeros, (bits >> 63) != 0};
}

template <std::size_t words>
struct Vector {
  Integer<words> x, y, z;
  friend Vector operator-(const Vector& u, const Vector& v) noexcept { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
  bool is_zero() const noexcept { return x.is_zero() && y.is_zero() && z.is_zero(); }
};
template <std::size_t m, std::size_t n>
Integer<m + n> dot(const Vector<m>& u, const Vector<n>& v) noexcept {
  return (u.x * v.x + u.y * v.y) + u.z * v.z;
}
template <std::size_t n>
Vector<2 * n> cross(const Vector<n>& u, const Vector<n>& v) noexcept {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

// The reduced test (kernel/rungs/reduced.h) with non-strict sides, which decides every triangle; for the open sphere
// with non-strict radii too, of axes that have a normal: the distance is at least r > 0 iff some such axis has all of
// the triangle at distance r or farther (exact/signs.h, is_touching).
//
// Sizes: the thirteen numbers are below 2^(n - 1) in magnitude, the six differences of points below 2^n. Then A.A stays
// below 2^(2n + 2), N and V below 2^(2n + 1) by component, N.N, N.V and V.V below 2^(4n + 4), d below 2^(3n + 3),
// degree 6 below 2^(6n + 6), and margins below twice that. In 1, 2, 3, 4 and 6 times `words` words all fit, a sign
// included, where n <= 64 words - 2.
template <std::size_t words>
struct Test {
  Vector<words> A, B, C;
  Integer<2 * words> rr;
  bool open;

  template <std::size_t n>
  bool beyond(const Integer<n>& margin) const noexcept {
    return open ? !margin.is_negative() : margin.is_positive();
  }
  bool vertex(const Vector<words>& from, const Vector<words>& one, const Vector<words>& other) const noexcept {
    return beyond(dot(from, from) - rr) && !dot(from, one - from).is_negative() &&
           !dot(from, other - from).is_negative();
  }
  bool plane(const Vector<2 * words>& V) const noexcept {
    if (V.is_zero()) return false;
    const Integer<3 * words> d = dot(A, V);
    return beyond(d * d - rr * dot(V, V));
  }
  bool edge(const Vector<words>& from, const Vector<words>& to, const Vector<2 * words>& V) const noexcept {
    const Vector<words> along = to - from;
    if (along.is_zero()) return false;
    const Vector<2 * words> N = cross(from, along);
    const Integer<4 * words> side = dot(N, V);
    return !side.is_positive() && beyond(dot(N, N) - rr * dot(along, along));
  }
  bool separates() const noexcept {
    if (vertex(A, B, C) || vertex(B, C, A) || vertex(C, A, B)) return true;
    const Vector<2 * words> V = cross(B - A, C - A);
    return plane(V) || edge(A, B, V) || edge(B, C, V) || edge(C, A, V);
  }
};

template <std::size_t words>
[[gnu::noinline]] bool separated_in(const Dyadic (&q)[13], int unit, bool open) noexcept {
  const auto number = [&](int i) {
    const Dyadic& x = q[i];
    return x.significand == 0 ? Integer<words>{}
                              : shifted<words>(x.significand, static_cast<unsigned>(x.exponent - unit), x.negative);
  };
  const auto point = [&](int i) { return Vector<words>{number(i), number(i + 1), number(i + 2)}; };
  const Vector<words> P = point(9);
  const Integer<words> r = number(12);
  return Test<words>{point(0) - P, point(3) - P, point(6) - P, r * r, open}.separates();
}

// The numbers are multiples of 2^unit, below 2^top in magnitude; zero tells nothing.
struct Span {
  int unit = 1024, top = -1075;
  void include(const Dyadic& x) noexcept {
    if (x.significand == 0) return;
    const int above = x.exponent + static_cast<int>(std::bit_width(x.significand));
    if (x.exponent < unit) unit = x.exponent;
    if (above > top) top = above;
  }
  bool is_empty() const noexcept { return top < unit; }
  int bits() const noexcept { return is_empty() ? 1 : top - unit + 1; }  // n above
};

}  // namespace

bool exactly_separated(const double (&query)[13], Question question) noexcept {
  bool open = question == Question::open_sphere;
  Dyadic q[13];
  Span span;
  for (int i = 0; i < 13; ++i) q[i] = dyadic(query[i]);
  for (int i = 0; i < 12; ++i) span.include(q[i]);
  Dyadic& r = q[12];
  if (r.significand == 0) {
    if (open) return true;  // an open sphere of radius 0 is empty
  } else if (!span.is_empty() &&
             r.exponent + static_cast<int>(std::bit_width(r.significand)) <= span.unit - 2 * span.bits() - 2) {
    // A radius so small that rr times 1, |AB|^2 < 2^(2n + 2) or |V|^2 < 2^(4n + 4) is below 1, and the other side of a
    // radius comparison is an integer: beyond iff that is not zero, closed or open. Meshes are asked with the least
    // radius that there is.
    r = {};
    open = false;
  } else {
    span.include(r);
  }
  const int unit = span.unit, bits = span.bits();
  if (bits <= 62) return separated_in<1>(q, unit, open);
  if (bits <= 126) return separated_in<2>(q, unit, open);
  if (bits <= 190) return separated_in<3>(q, unit, open);
  if (bits <= 318) return separated_in<5>(q, unit, open);  // all of binary32: 128 + 149 + 1
  if (bits <= 702) return separated_in<11>(q, unit, open);
  return separated_in<33>(q, unit, open);  // all of binary64: 1024 + 1074 + 1 <= 64 33 - 2
}

}  // namespace axiscert::certified
