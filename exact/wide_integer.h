// Integers of a fixed number of 64-bit words, two's complement: sums, differences and exact products, without a branch
// on a value or an allocation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace axiscert {

__extension__ typedef __int128 Int128;  // ISO C++ has no name for it
__extension__ typedef unsigned __int128 UInt128;

// Words are unsigned, least first, and sums and differences are taken modulo 2^(64 words): right wherever the result
// lies in [-2^(64 words - 1), 2^(64 words - 1)), whatever the partial sums did. That it does is the caller's to show.
template <std::size_t words>
class WideInteger {
 public:
  explicit WideInteger(std::int64_t x) {
    word_.fill(x < 0 ? ~std::uint64_t{0} : 0);
    word_[0] = static_cast<std::uint64_t>(x);
  }
  explicit WideInteger(Int128 x)
    requires(words >= 2)
      : WideInteger(static_cast<std::int64_t>(x >> 64)) {
    word_[1] = word_[0];
    word_[0] = static_cast<std::uint64_t>(x);
  }
  // The low words of a number that fits them.
  template <std::size_t others>
    requires(others > words)
  explicit WideInteger(const WideInteger<others>& x) {
    for (std::size_t i = 0; i < words; ++i) word_[i] = x.word(i);
  }

  std::uint64_t word(std::size_t i) const { return word_[i]; }
  bool is_negative() const { return (word_[words - 1] >> 63) != 0; }
  bool is_zero() const {
    std::uint64_t any = 0;
    for (const std::uint64_t w : word_) any |= w;
    return any == 0;
  }

  friend WideInteger operator+(WideInteger a, const WideInteger& b) {
    a.template add<0>(b.word_, ~std::uint64_t{0});
    return a;
  }
  friend WideInteger operator-(WideInteger a, const WideInteger& b) {
    a.template subtract<0>(b.word_, ~std::uint64_t{0});
    return a;
  }

  // Exact: the product is at most 2^(64 words - 1) 2^(64 others - 1), which fits words + others.
  template <std::size_t others>
  WideInteger<words + others> operator*(const WideInteger<others>& other) const {
    return WideInteger<words + others>::product(*this, other);
  }

 private:
  template <std::size_t>
  friend class WideInteger;
  WideInteger() = default;

  template <std::size_t m, std::size_t n>
  static WideInteger product(const WideInteger<m>& a, const WideInteger<n>& b) {
    static_assert(m + n == words);
    WideInteger result;
    if constexpr (words == 2) {
      const Int128 p =
          static_cast<Int128>(static_cast<std::int64_t>(a.word_[0])) * static_cast<std::int64_t>(b.word_[0]);
      result.word_ = {static_cast<std::uint64_t>(p), static_cast<std::uint64_t>(p >> 64)};
    } else {
      result.word_.fill(0);
#pragma GCC unroll 12
      for (std::size_t i = 0; i < m; ++i) {
        std::uint64_t carry = 0;
#pragma GCC unroll 12
        for (std::size_t j = 0; j < n; ++j) {
          // (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1
          const UInt128 sum = static_cast<UInt128>(a.word_[i]) * b.word_[j] + result.word_[i + j] + carry;
          result.word_[i + j] = static_cast<std::uint64_t>(sum);
          carry = static_cast<std::uint64_t>(sum >> 64);
        }
        result.word_[i + n] = carry;
      }
      // Read as unsigned, a negative a is a + 2^(64 m): the product has 2^(64 m) b too much, and likewise for b. Where
      // both are, 2^(64 words) is lost too, which is none.
      result.template subtract<m>(b.word_, a.sign_mask());
      result.template subtract<n>(a.word_, b.sign_mask());
    }
    return result;
  }

  std::uint64_t sign_mask() const {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(word_[words - 1]) >> 63);
  }

  // Adds or subtracts the number, shifted up by `from` words and cut off at the top, if the mask is all ones; nothing
  // if it is 0. The words from `from` on are as many as the number's, or fewer.
  template <std::size_t from, std::size_t n>
  void add(const std::array<std::uint64_t, n>& number, std::uint64_t mask) {
    std::uint64_t carry = 0;
#pragma GCC unroll 12
    for (std::size_t i = from; i < words; ++i) {
      const UInt128 sum = static_cast<UInt128>(word_[i]) + (number[i - from] & mask) + carry;
      word_[i] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64);
    }
  }
  template <std::size_t from, std::size_t n>
  void subtract(const std::array<std::uint64_t, n>& number, std::uint64_t mask) {
    static_assert(words - from <= n);
    std::uint64_t borrow = 0;
#pragma GCC unroll 12
    for (std::size_t i = from; i < words; ++i) {
      const UInt128 difference = static_cast<UInt128>(word_[i]) - (number[i - from] & mask) - borrow;
      word_[i] = static_cast<std::uint64_t>(difference);
      borrow = static_cast<std::uint64_t>(difference >> 64) & 1u;
    }
  }

  std::array<std::uint64_t, words> word_;
};

}  // namespace axiscert
