// Integers of a run-time number of words up to a fixed capacity, by GMP's mpn functions: sums, differences and exact
// products without an allocation of their own. Serves for many words, as WideInteger does for a few.
#pragma once

#include <gmp.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace axiscert {

// Sign and magnitude, words least significant first, the last of them not zero: the time of an operation depends on the
// size of the numbers and not on the capacity. The caller must ensure that no result is 2^(64 capacity) or greater.
template <std::size_t capacity>
class LimbInteger {
  static_assert(GMP_NUMB_BITS == 64);

 public:
  LimbInteger() : size_(0), is_negative_(false) {}
  explicit LimbInteger(std::int64_t x) : size_(x == 0 ? 0 : 1), is_negative_(x < 0) {
    word_[0] = x < 0 ? -static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x);
  }
  LimbInteger(const LimbInteger& other) { *this = other; }
  LimbInteger& operator=(const LimbInteger& other) {
    size_ = other.size_;
    is_negative_ = other.is_negative_;
    std::copy_n(other.word_, size_, word_);
    return *this;
  }
  // significand 2^shift.
  static LimbInteger shifted(std::int64_t significand, unsigned shift) {
    LimbInteger result(significand);
    if (significand == 0) return result;
    const std::uint64_t magnitude = result.word_[0];
    const std::size_t whole = shift / 64;
    std::fill_n(result.word_, whole, std::uint64_t{0});
    result.word_[whole] = magnitude << (shift % 64);
    result.size_ = whole + 1;
    const std::uint64_t beyond = shift % 64 == 0 ? 0 : magnitude >> (64 - shift % 64);
    if (beyond != 0) result.word_[result.size_++] = beyond;
    return result;
  }

  bool is_negative() const { return size_ != 0 && is_negative_; }
  bool is_zero() const { return size_ == 0; }

  LimbInteger operator-() const {
    LimbInteger result = *this;
    result.is_negative_ = !is_negative_;
    return result;
  }
  friend LimbInteger operator+(const LimbInteger& a, const LimbInteger& b) { return sum(a, b, b.is_negative_); }
  friend LimbInteger operator-(const LimbInteger& a, const LimbInteger& b) { return sum(a, b, !b.is_negative_); }

  template <std::size_t others>
  LimbInteger<capacity + others> operator*(const LimbInteger<others>& other) const {
    LimbInteger<capacity + others> result;
    if (size_ == 0 || other.size_ == 0) return result;
    if (size_ >= other.size_) mpn_mul(result.word_, word_, length(), other.word_, other.length());
    else mpn_mul(result.word_, other.word_, other.length(), word_, length());
    result.size_ = size_ + other.size_;
    if (result.word_[result.size_ - 1] == 0) --result.size_;
    result.is_negative_ = is_negative_ != other.is_negative_;
    return result;
  }

  // Calls use(mpz) with a view of the number as a GMP integer.
  template <class Use>
  auto as_mpz(Use&& use) const {
    mpz_t view;
    return use(static_cast<mpz_srcptr>(mpz_roinit_n(view, word_, is_negative_ ? -length() : length())));
  }

 private:
  template <std::size_t>
  friend class LimbInteger;

  mp_size_t length() const { return static_cast<mp_size_t>(size_); }

  static int order_of_magnitudes(const LimbInteger& a, const LimbInteger& b) {
    if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
    return a.size_ == 0 ? 0 : mpn_cmp(a.word_, b.word_, a.length());
  }

  // a + b or a - b; `b_is_negative` is the sign to use for b.
  static LimbInteger sum(const LimbInteger& a, const LimbInteger& b, bool b_is_negative) {
    LimbInteger result;
    const int order = order_of_magnitudes(a, b);
    const LimbInteger &greater = order < 0 ? b : a, &less = order < 0 ? a : b;
    if (less.size_ == 0) {
      result = greater;
      if (order < 0) result.is_negative_ = b_is_negative;
      return result;
    }
    if (a.is_negative_ == b_is_negative) {
      const mp_limb_t carry = mpn_add(result.word_, greater.word_, greater.length(), less.word_, less.length());
      result.size_ = greater.size_;
      if (carry != 0) result.word_[result.size_++] = carry;
      result.is_negative_ = b_is_negative;
    } else if (order != 0) {
      mpn_sub(result.word_, greater.word_, greater.length(), less.word_, less.length());
      result.size_ = greater.size_;
      while (result.word_[result.size_ - 1] == 0) --result.size_;
      result.is_negative_ = order < 0 ? b_is_negative : a.is_negative_;
    }
    return result;
  }

  std::size_t size_;
  bool is_negative_;  // unspecified if the number is zero
  mp_limb_t word_[capacity];
};

}  // namespace axiscert
