// Integers stored by their nonzero digits, for numbers that are far apart: the difference of 2^1000 and 1 has two
// digits. They are on the stack.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "kernel/sphere_triangle/certified/integer.h"
#include "kernel/sphere_triangle/certified/exact_margins.h"

namespace axiscert::certified {

// A value of some degree in a query's numbers, in units of the least double to that power. The digits are from -2^55 to
// 2^55 - 1, to the base 2^56: this form of a number is unique, and no borrow travels through it. In those units the
// numbers are below 2^(n - 1), n = 2099, and the values and their partial sums below 2^(degree n + 7) (exact_step.cpp,
// Integers); a number below 2^b has at most (b + 2) / 56 digits, rounded up, which is 38 per degree.
template <int degree>
struct BalancedDigits {
  static constexpr int base_bits = 56, most = 38 * degree;
  static_assert(base_bits * most >= degree * 2099 + 7 + 2);

  std::int64_t digit[most];
  std::uint8_t place[most];  // the places of the digits, ascending
  int size = 0;

  // The digits after the last are neither initialised nor copied: they would be most of a copy, and most of a zero.
  BalancedDigits() noexcept {}
  BalancedDigits(const BalancedDigits& x) noexcept { *this = x; }
  BalancedDigits& operator=(const BalancedDigits& x) noexcept {
    size = x.size;
    std::copy_n(x.digit, size, digit);
    std::copy_n(x.place, size, place);
    return *this;
  }

  bool is_zero() const noexcept { return size == 0; }
  bool is_positive() const noexcept { return size != 0 && digit[size - 1] > 0; }
  bool is_negative() const noexcept { return size != 0 && digit[size - 1] < 0; }

  // Appends the last digit of x at a place above all others; returns the carry to the next place.
  Int128 add_digit_of(Int128 x, int at) noexcept {
    const auto last = static_cast<std::int64_t>(static_cast<std::uint64_t>(x) << (64 - base_bits)) >> (64 - base_bits);
    if (last != 0) {
      digit[size] = last;
      place[size++] = static_cast<std::uint8_t>(at);
    }
    return (x - last) >> base_bits;
  }
};

inline BalancedDigits<1> digits_of(const Dyadic& x) noexcept {
  BalancedDigits<1> made;
  const int shift = x.exponent + 1074, bits = made.base_bits;
  const auto significand = static_cast<std::int64_t>(x.significand);
  Int128 rest = Int128{x.negative ? -significand : significand} << (shift % bits);
  for (int place = shift / bits; rest != 0; ++place) rest = made.add_digit_of(rest, place);
  return made;
}

template <int degree>
BalancedDigits<degree> operator-(const BalancedDigits<degree>& x, const BalancedDigits<degree>& y) noexcept {
  BalancedDigits<degree> difference;
  Int128 carry = 0;
  for (int i = 0, j = 0, place = 0; i < x.size || j < y.size || carry != 0; ++place) {
    if (carry == 0) {  // skip to the next place with a digit
      place = x.most;
      if (i < x.size) place = x.place[i];
      if (j < y.size && y.place[j] < place) place = y.place[j];
    }
    if (i < x.size && x.place[i] == place) carry += x.digit[i++];
    if (j < y.size && y.place[j] == place) carry -= y.digit[j++];
    carry = difference.add_digit_of(carry, place);
  }
  return difference;
}

// Sums of products before carries: fewer than 2^16 products of two digits are below 2^126.
template <int degree>
class DigitSum {
 public:
  template <int m>
  void add(const BalancedDigits<m>& x, const BalancedDigits<degree - m>& y, int sign) noexcept {
    for (int i = 0; i < x.size; ++i) {
      const std::int64_t digit = sign * x.digit[i];
      for (int j = 0; j < y.size; ++j) at(x.place[i] + y.place[j]) += Int128{digit} * y.digit[j];
    }
  }
  BalancedDigits<degree> carried() const noexcept {
    BalancedDigits<degree> x;
    Int128 carry = 0;
    for (int group = 0; carry != 0 || used_ >> group != 0; ++group) {
      if (carry == 0) group += std::countr_zero(used_ >> group);  // skip to the next group in use
      const bool is_used = ((used_ >> group) & 1u) != 0;
      for (int place = group * group_size; place < (group + 1) * group_size; ++place) {
        if (is_used) carry += at_[place];
        carry = x.add_digit_of(carry, place);
      }
    }
    return x;
  }

 private:
  static constexpr int group_size = 4;  // places; those of a group are set to zero together when the first of them is
                                        // added to
  static constexpr int groups = (BalancedDigits<degree>::most + group_size - 1) / group_size;
  static_assert(groups < 64);

  Int128& at(int place) noexcept {
    const int group = place / group_size;
    if (((used_ >> group) & 1u) == 0) {
      used_ |= std::uint64_t{1} << group;
      for (int i = 0; i < group_size; ++i) at_[group * group_size + i] = 0;
    }
    return at_[place];
  }

  std::uint64_t used_ = 0;
  Int128 at_[groups * group_size];
};

template <class Result, int m, int n>
Result product(const BalancedDigits<m>& a, const BalancedDigits<n>& b) noexcept {
  DigitSum<m + n> sum;
  sum.add(a, b, 1);
  return sum.carried();
}
template <class Result, int a, int b, int c, int d>
Result difference_of_products(const BalancedDigits<a>& x, const BalancedDigits<b>& y, const BalancedDigits<c>& z,
                              const BalancedDigits<d>& w) noexcept {
  DigitSum<a + b> sum;
  sum.add(x, y, 1);
  sum.add(z, w, -1);
  return sum.carried();
}
template <class Result, int m, int n>
Result dot(const Vector<BalancedDigits<m>>& u, const Vector<BalancedDigits<n>>& v) noexcept {
  DigitSum<m + n> sum;
  sum.add(u.x, v.x, 1);
  sum.add(u.y, v.y, 1);
  sum.add(u.z, v.z, 1);
  return sum.carried();
}

}  // namespace axiscert::certified
