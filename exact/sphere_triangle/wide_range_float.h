// binary32's significand with binary64's exponents: the operations of R-infinity in binary32 at hardware speed.
#pragma once

#include <bit>
#include <cstdint>

#include "exact/sphere_triangle/degree.h"

namespace axiscert {

// A binary64 of at most 24 bits. Every operation gives its exact result rounded once to 24 bits, nearest even, as long
// as no number leaves binary64's normal range, which covers() decides for given formulae. The processor has to round to
// nearest.
//
// It rounds to 53 bits first. That this changes nothing is known for p' >= 2p + 2 bits (S. A. Figueroa, "When is double
// rounding innocuous?", 1995; here 53 >= 50). In short: a product has at most 48 bits and is not rounded at first. In a
// sum let a be the operand of greater magnitude, 2^q its unit in the last of 24 places and 2^l that of b, |b| < 2^(l +
// 24). Where l >= q - 28, the sum is a multiple of 2^(q - 28) below 2^(q + 25) and has at most 53 bits. Else |b| < 2^(q
// - 5): the sum lies between a -+ 2^(q - 5), which have at most 53 bits, and so does the rounded sum; a's neighbours of
// 24 bits are at least 2^(q - 1) away from it, so that either rounding ends at a.
class WideRangeFloat {
 public:
  WideRangeFloat() = default;
  explicit WideRangeFloat(double x) : value_(x) {}  // x has at most 24 bits

  // Whether all intermediate results of a side with this bound are 0 or normal binary64 numbers if coordinates and
  // radius are finite binary32 numbers. These are multiples of 2^-149 below 2^128 in magnitude.
  // - Not too small: a number of degree k is a multiple of 2^(-149 k), as sums and products of such multiples are, and
  //   the nearest number of 24 bits to a multiple of u: either it is that multiple, or its own unit is u or more. So a
  //   number is 0 or at least 2^(-149 k), and 2^-894 for k = 6 is above 2^-1022.
  // - Not too great: `bits` adds up as powers of two bound magnitudes: |x| <= 2^m and |y| <= 2^n give |x + y| <=
  //   2^(max + 1) and |x y| <= 2^(m + n), and rounding leaves a number that a power of two bounds within it.
  static constexpr bool covers(const BitLength& bits) { return 149 * bits.per_bit <= 1022 && bits.at(128) <= 1023; }

  friend WideRangeFloat operator+(WideRangeFloat a, WideRangeFloat b) { return rounded(a.value_ + b.value_); }
  friend WideRangeFloat operator-(WideRangeFloat a, WideRangeFloat b) { return rounded(a.value_ - b.value_); }
  friend WideRangeFloat operator*(WideRangeFloat a, WideRangeFloat b) { return rounded(a.value_ * b.value_); }
  friend bool operator>(WideRangeFloat a, WideRangeFloat b) { return a.value_ > b.value_; }
  friend bool operator>=(WideRangeFloat a, WideRangeFloat b) { return a.value_ >= b.value_; }
  double value() const { return value_; }

 private:
  // Rounds to nearest even: adds just less than half a unit, or half of one if the last place is odd, and truncates. A
  // carry out of the significand goes into the exponent, which is right; 0 stays 0.
  static WideRangeFloat rounded(double x) {
    constexpr int dropped = 53 - 24;
    constexpr std::uint64_t unit = std::uint64_t{1} << dropped;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t carried = bits + (unit / 2 - 1) + ((bits >> dropped) & 1u);
    return WideRangeFloat(std::bit_cast<double>(carried & ~(unit - 1)));
  }

  double value_ = 0;
};

}  // namespace axiscert
