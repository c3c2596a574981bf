// A number, a bound of its error and an exponent that never ends: what follows from it is certain, and neither
// overflows nor underflows, whatever binary64s it was made of.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "kernel/base/geometry.h"

namespace axiscert {

// The exact number is within (value +- error more) 2^exponent, more = 1 + 2^-40. An exact zero has value = error = 0.
//
// With size = |value| + error: size >= 1/2 and below 2^12 for all numbers but 0, in sums and products of degree 6 and
// less whose factors are differences, sums, or products of two:
//   a leaf, and what a sum gives, is put to max(|value|, error) in [1, 2), so its size is in [1, 4);
//   the sizes of factors multiply, exactly: |a b| + (|a| b.error + a.error (|b| + b.error)) = size_a size_b, and a
//   rounding error is added. No product here has more than four factors that were not put so before.
//
// Roundings. 2^-53 |value| is what the value's own sum or product is off by. `error` is made by sums and products of
// numbers that are not negative, rounded to nearest: with k roundings counted through all factors of its terms it is at
// least (1 - 2^-53)^k of what it stands for. k is below 2,000 for degree 6, which `more` makes up for.
// An error is 0 or at least 2^-352 of its number's size: a leaf's is exactly that of one subtraction of numbers that
// lie at most 2^300 apart, every other one at least 2^-53 |value|. So errors do not underflow, nor do values in
// [2^-511, 2^12). A value below that has an error of 1/4 or more, and so does all that is made of it; what underflow
// adds, 2^-1074, is less than a rounding of that error.
struct WideEnclosed {
  double value = 0, error = 0;
  int exponent = zero_exponent;

  WideEnclosed() = default;
  // Exactly. Halved, so that the power of two that puts the greatest numbers to [1, 2) is a normal one.
  AXISCERT_INLINE explicit WideEnclosed(double x) {
    const bool small = std::fabs(x) < 0x1p-900;
    *this = put(x * (small ? 0x1p200 : 0.5), 0, small ? -200 : 1);
  }
  // x - y; without an error where the two, put at one exponent, have a binary64 for a difference.
  AXISCERT_INLINE static WideEnclosed difference(double x, double y) {
    const AtOneExponent at(WideEnclosed(x), WideEnclosed(-y));
    const double sum = at.a + at.b, part = sum - at.a;  // Knuth's sum: its error is exact
    return put(sum, at.error + std::fabs((at.a - (sum - part)) + (at.b - part)), at.exponent);
  }

  AXISCERT_INLINE friend WideEnclosed operator+(const WideEnclosed& a, const WideEnclosed& b) {
    const AtOneExponent at(a, b);
    const double sum = at.a + at.b;
    return put(sum, at.error + 0x1p-53 * std::fabs(sum), at.exponent);
  }
  AXISCERT_INLINE friend WideEnclosed operator-(const WideEnclosed& a) { return {-a.value, a.error, a.exponent}; }
  AXISCERT_INLINE friend WideEnclosed operator-(const WideEnclosed& a, const WideEnclosed& b) { return a + -b; }
  AXISCERT_INLINE friend WideEnclosed operator*(const WideEnclosed& a, const WideEnclosed& b) {
    const double product = a.value * b.value, size_a = std::fabs(a.value), size_b = std::fabs(b.value);
    return {product, (size_a * b.error + a.error * (size_b + b.error)) + 0x1p-53 * std::fabs(product),
            a.exponent + b.exponent};
  }

  // Within the same error, since | |x| - |v| | <= |x - v|.
  WideEnclosed magnitude() const { return {std::fabs(value), error, exponent}; }

  // Certain; where none of the three holds, none is known.
  bool is_zero() const { return value == 0 && error == 0; }
  bool is_positive() const { return value > slack(); }
  bool is_negative() const { return -value > slack(); }
  // Bounds of the magnitude, in units of 2^exponent.
  double least() const { return std::max(0.0, std::fabs(value) - slack()) * (1 - 0x1p-50); }
  double greatest() const { return (std::fabs(value) + slack()) * (1 + 0x1p-50); }

  // Of two enclosures of one number, that whose error is not the greater; either would do.
  AXISCERT_INLINE static const WideEnclosed& narrower(const WideEnclosed& a, const WideEnclosed& b) {
    const int apart = std::clamp(a.exponent - b.exponent, -most_apart, most_apart);
    return a.error * power(apart) <= b.error ? a : b;
  }

 private:
  // Below that of any number that is not 0, times any power up to the sixth.
  static constexpr int zero_exponent = -(1 << 20);
  static constexpr int most_apart = 300;

  AXISCERT_INLINE WideEnclosed(double v, double e, int x) : value(v), error(e), exponent(x) {}

  double slack() const { return error * (1 + 0x1p-39); }

  // Two numbers in units of the greater 2^exponent. The smaller is divided by 2^300 where it lies farther below: it is
  // off by less than its size there, 2^-300 as given, and 2^-100 of that size is added to the error.
  struct AtOneExponent {
    int exponent;
    double a, b, error;  // error: of both
    AXISCERT_INLINE AtOneExponent(const WideEnclosed& u, const WideEnclosed& v)
        : exponent(std::max(u.exponent, v.exponent)) {
      const int below_u = exponent - u.exponent, below_v = exponent - v.exponent;
      const double scale_u = power(-std::min(below_u, most_apart)), scale_v = power(-std::min(below_v, most_apart));
      a = u.value * scale_u;
      b = v.value * scale_v;
      error = u.error * scale_u + v.error * scale_v;
      if (below_u + below_v > most_apart) [[unlikely]] {
        const WideEnclosed& small = below_u > below_v ? u : v;
        error += 0x1p-100 * (std::fabs(small.value) + small.error);
      }
    }
  };

  // 2^e, -1022 <= e <= 1023.
  AXISCERT_INLINE static double power(int e) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
  }
  // The greater of |v| and e is 0 or in [2^-1000, 2^1023).
  AXISCERT_INLINE static WideEnclosed put(double v, double e, int x) {
    const auto size = std::bit_cast<std::uint64_t>(std::max(std::fabs(v), e));
    if (size == 0) return {};
    const int shift = static_cast<int>(size >> 52) - 1023;
    const double scale = power(-shift);
    return {v * scale, e * scale, x + shift};
  }
};

}  // namespace axiscert
