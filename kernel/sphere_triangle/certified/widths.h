// Which number type holds a query: integers of as many words as it needs or, for numbers far apart, nonzero digits.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "kernel/sphere_triangle/certified/balanced_digits.h"
#include "kernel/sphere_triangle/certified/integer.h"

namespace axiscert::certified {

// Integers with as many words as the values of each degree need, for a query whose thirteen numbers are below 2^(n - 1)
// in magnitude: the six differences of points stay below 2^n, A.A below 2^(2n + 2), a component of N and V below 2^(2n
// + 1), d below 2^(3n + 3), N.N, N.V and V.V below 2^(4n + 4), degree 6 below 2^(6n + 6); margins below twice that; and
// a sign.
template <int n>
struct Integers {
  static constexpr int bits(int degree) { return degree * n + (degree == 1 ? 1 : degree + 2); }
  template <int degree>
  using Value = Integer<static_cast<std::size_t>((bits(degree) + 63) / 64)>;
};
// The sizes that numbers of more than 62 bits, or with a least bit of their own, are converted to: values of 1, 2, 3, 4
// and 6 words by degree; 2, 3, 5, 6 and 9; 2, 4, 6, 8 and 12; and 5, 9, 14, 18 and 27 for numbers that span no more
// than those of binary32 can, 278 bits. proofs/certified records for each span which of them is taken, and its words.
inline constexpr int integer_sizes[] = {62, 94, 126, 286};
// The least size that holds numbers of a span; 0 where none does.
constexpr int integer_size_for(int bits) noexcept {
  for (const int size : integer_sizes) {
    if (bits <= size) return size;
  }
  return 0;
}
// For numbers so far apart that most of their digits are zero.
struct Digits {
  template <int degree>
  using Value = BalancedDigits<degree>;
};
template <class Numbers>
using Query13 = typename Numbers::template Value<1>[13];

// The exponent of the greatest negligible radius, where the other twelve numbers are integers below 2^(n - 1). With r
// at most this power of two, rr times 1, |AB|^2 < 2^(2n + 2) or |V|^2 < 2^(4n + 4) is below 1, and the other side of a
// radius comparison is an integer. On an axis that has a normal, the triangle is then beyond iff that integer is not
// zero, for the closed and the open sphere, as it is for the closed sphere of radius 0. Such queries occur where meshes
// are asked with the least positive radius.
constexpr int negligible_radius(int n) { return -2 * n - 2; }

// Converts the numbers to integers below 2^(bits - 1) in units of 2^(top - bits + 1), where 2^top is the least power of
// two above all of them. False if some are not such integers, except a radius that is negligible in these units. The
// conversions are the processor's own: an inexact one does not give the number back, and a radius that underflows is
// negligible however it is rounded.
template <int bits>
bool fit(const double (&q)[13], int top, Query13<Integers<bits>>& numbers, bool& open) noexcept {
  static_assert(bits <= 62);
  const int shift = bits - 1 - top;
  if (shift < -1000 || shift > 1000) return false;
  const auto power = [](int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
  };
  const double scale = power(shift), back = power(-shift);
  for (int i = 0; i < 13; ++i) {
    const double scaled = q[i] * scale;
    const auto x = static_cast<std::int64_t>(scaled);
    numbers[i].word[0] = static_cast<std::uint64_t>(x);
    if (static_cast<double>(x) * back == q[i]) continue;
    if (i != 12 || scaled > power(negligible_radius(bits))) return false;
    open = false;
  }
  return true;
}
inline int top_of(const double (&q)[13]) noexcept {
  std::uint64_t greatest = 0;
  for (const double x : q) greatest = std::max(greatest, std::bit_cast<std::uint64_t>(x) << 1);
  return static_cast<int>(greatest >> 53) - 1022;
}

// The numbers are multiples of 2^unit and below 2^top in magnitude; zero does not change these.
struct Span {
  int unit = 1024, top = -1075;
  void include(const Dyadic& x) noexcept {
    if (x.significand == 0) return;
    if (x.exponent + x.zeros < unit) unit = x.exponent + x.zeros;
    if (x.top() > top) top = x.top();
  }
  bool is_empty() const noexcept { return top < unit; }
  int bits() const noexcept { return is_empty() ? 1 : top - unit + 1; }  // the n of Integers
};

// The numbers as integers below 2^(bits - 1), in units of 2^unit.
template <int bits>
void convert(const double (&q)[13], int unit, Query13<Integers<bits>>& numbers) noexcept {
  for (int i = 0; i < 13; ++i) {
    const Dyadic x(q[i]);
    numbers[i] = shifted<typename Integers<bits>::template Value<1>>(
        x.significand >> x.zeros, static_cast<unsigned>(x.exponent + x.zeros - unit), x.negative);
  }
}
inline void convert(const double (&q)[13], Query13<Digits>& numbers) noexcept {
  for (int i = 0; i < 13; ++i) numbers[i] = digits_of(Dyadic(q[i]));
}

}  // namespace axiscert::certified
