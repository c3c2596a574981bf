// A number with a bound of its error and an unbounded exponent: every conclusion drawn from it is certain, and it
// neither overflows nor underflows, whatever binary64 numbers it was made from.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "kernel/base/geometry.h"

namespace axiscert {

// The exact number is within (value +- error more) 2^exponent, more = 1 + 2^-40. An exact zero has value = error = 0.
//
// With size = |value| + error: 1/2 <= size < 2^12 for all numbers but 0, in sums and products of degree 6 and less
// whose factors are differences, sums, or products of two:
//   a leaf, and the result of a sum, is scaled so that max(|value|, error) is in [1, 2), so its size is in [1, 4);
//   the sizes of factors multiply, exactly: |a b| + (|a| b.error + a.error (|b| + b.error)) = size_a size_b, and a
//   rounding error is added. No product here has more than four factors that were not scaled so before.
//
// Roundings. The value's own sum or product errs by at most 2^-53 |value|. `error` is made by sums and products of
// non-negative numbers, rounded to nearest: with k roundings counted through all factors of its terms it is at least (1
// - 2^-53)^k of its exact value. k is below 2,000 for degree 6, which `more` makes up for.
// An error is 0 or at least 2^-352 of its number's size: a leaf's is exactly that of one subtraction of numbers that
// lie at most 2^300 apart, every other one at least 2^-53 |value|. So errors do not underflow, nor do values in
// [2^-511, 2^12). A value below that range has an error of 1/4 or more, and so has every number made from it; the error
// that underflow adds, 2^-1074, is less than a rounding of that error.
struct WideEnclosed {
  double value = 0, error = 0;
  int exponent = zero_exponent;

  WideEnclosed() = default;
  // An exact conversion. Halved, so that the power of two that scales the greatest numbers to [1, 2) is a normal
  // number.
  AXISCERT_INLINE explicit WideEnclosed(double x) {
    const bool small = std::fabs(x) < 0x1p-900;
    *this = put(x * (small ? 0x1p200 : 0.5), 0, small ? -200 : 1);
  }
  // x - y; without an error if the difference, with both at one exponent, is a binary64 number.
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

  // Each predicate is true only if it is certain; if none of the three holds, the sign is not known.
  bool is_zero() const { return value == 0 && error == 0; }
  bool is_positive() const { return value > slack(); }
  bool is_negative() const { return -value > slack(); }
  // Bounds of the magnitude, in units of 2^exponent.
  double least() const { return std::max(0.0, std::fabs(value) - slack()) * (1 - 0x1p-50); }
  double greatest() const { return (std::fabs(value) + slack()) * (1 + 0x1p-50); }

  // The one of two enclosures of the same number with the smaller error (a, if the errors are equal); either would be
  // correct.
  AXISCERT_INLINE static const WideEnclosed& narrower(const WideEnclosed& a, const WideEnclosed& b) {
    const int apart = std::clamp(a.exponent - b.exponent, -most_apart, most_apart);
    return a.error * power(apart) <= b.error ? a : b;
  }

 private:
  // An exponent below that of any number that is not 0, and of any power of such a number up to the sixth.
  static constexpr int zero_exponent = -(1 << 20);
  static constexpr int most_apart = 300;

  AXISCERT_INLINE WideEnclosed(double v, double e, int x) : value(v), error(e), exponent(x) {}

  double slack() const { return error * (1 + 0x1p-39); }

  // Two numbers in units of the greater 2^exponent. If the exponents differ by more than 300, the smaller number is
  // divided by 2^300 only: it is off by less than its size there, which is 2^-300 of its own size, and 2^-100 of that
  // size is added to the error.
  struct AtOneExponent {
    int exponent;
    double a, b, error;  // error: for both numbers together
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

  // 2^e; requires -1022 <= e <= 1023.
  AXISCERT_INLINE static double power(int e) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
  }
  // Requires that the greater of |v| and e is 0 or in [2^-1000, 2^1023).
  AXISCERT_INLINE static WideEnclosed put(double v, double e, int x) {
    const auto size = std::bit_cast<std::uint64_t>(std::max(std::fabs(v), e));
    if (size == 0) return {};
    const int shift = static_cast<int>(size >> 52) - 1023;
    const double scale = power(-shift);
    return {v * scale, e * scale, x + shift};
  }
};

}  // namespace axiscert
