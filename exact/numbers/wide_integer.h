// Integers of a fixed number of 64-bit words, two's complement: sums, differences and exact products, without a branch
// on a value or an allocation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#ifdef __x86_64__
#include <immintrin.h>
#endif

#include "kernel/base/address_sanitizer.h"

// Force inlining, since the words would go through memory otherwise. Not under AddressSanitizer, which instruments each
// access: the code would grow beyond what a compiler can handle.
#ifdef AXISCERT_ADDRESS_SANITIZER
#define AXISCERT_WORDS_INLINE
#else
#define AXISCERT_WORDS_INLINE __attribute__((always_inline))
#endif

namespace axiscert {

__extension__ typedef __int128 Int128;  // ISO C++ has no name for this type
__extension__ typedef unsigned __int128 UInt128;

namespace words {

// a + b + carry and a - b - borrow modulo 2^64; the carry out is 0 or 1. Written so that the compiler keeps the carry
// in a flag, which it does not do for a carry in an integer variable.
#ifdef __x86_64__
using Carry = unsigned char;
AXISCERT_WORDS_INLINE inline std::uint64_t add(std::uint64_t a, std::uint64_t b, Carry& carry) {
  unsigned long long sum;
  carry = _addcarry_u64(carry, a, b, &sum);
  return sum;
}
AXISCERT_WORDS_INLINE inline std::uint64_t subtract(std::uint64_t a, std::uint64_t b, Carry& borrow) {
  unsigned long long difference;
  borrow = _subborrow_u64(borrow, a, b, &difference);
  return difference;
}
#else
using Carry = std::uint64_t;
AXISCERT_WORDS_INLINE inline std::uint64_t add(std::uint64_t a, std::uint64_t b, Carry& carry) {
  const UInt128 sum = static_cast<UInt128>(a) + b + carry;
  carry = static_cast<std::uint64_t>(sum >> 64);
  return static_cast<std::uint64_t>(sum);
}
AXISCERT_WORDS_INLINE inline std::uint64_t subtract(std::uint64_t a, std::uint64_t b, Carry& borrow) {
  const UInt128 difference = static_cast<UInt128>(a) - b - borrow;
  borrow = static_cast<std::uint64_t>(difference >> 64) & 1u;
  return static_cast<std::uint64_t>(difference);
}
#endif

// Calls f with each index as a constant: the loop is unrolled before the optimiser runs.
template <std::size_t count, class F>
AXISCERT_WORDS_INLINE inline void for_each_index(F&& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>)
      AXISCERT_WORDS_INLINE { (f(std::integral_constant<std::size_t, i>{}), ...); }(std::make_index_sequence<count>());
}

}  // namespace words

// Words are unsigned, least significant first, and sums and differences are taken modulo 2^(64 words): the result is
// right if it lies in [-2^(64 words - 1), 2^(64 words - 1)), whatever the partial sums were. The caller must ensure
// that it does.
template <std::size_t count>
class WideInteger {
 public:
  AXISCERT_WORDS_INLINE explicit WideInteger(std::int64_t x) {
    word_.fill(x < 0 ? ~std::uint64_t{0} : 0);
    word_[0] = static_cast<std::uint64_t>(x);
  }
  AXISCERT_WORDS_INLINE explicit WideInteger(Int128 x)
    requires(count >= 2)
      : WideInteger(static_cast<std::int64_t>(x >> 64)) {
    word_[1] = word_[0];
    word_[0] = static_cast<std::uint64_t>(x);
  }
  // The low words of a wider number whose value fits them.
  template <std::size_t others>
    requires(others > count)
  AXISCERT_WORDS_INLINE explicit WideInteger(const WideInteger<others>& x) {
    words::for_each_index<count>([&](auto i) AXISCERT_WORDS_INLINE { word_[i] = x.word_[i]; });
  }

  AXISCERT_WORDS_INLINE bool is_negative() const { return (word_[count - 1] >> 63) != 0; }
  AXISCERT_WORDS_INLINE bool is_zero() const {
    std::uint64_t any = 0;
    words::for_each_index<count>([&](auto i) AXISCERT_WORDS_INLINE { any |= word_[i]; });
    return any == 0;
  }

  AXISCERT_WORDS_INLINE friend WideInteger operator+(const WideInteger& a, const WideInteger& b) {
    WideInteger sum;
    words::Carry carry = 0;
    words::for_each_index<count>(
        [&](auto i) AXISCERT_WORDS_INLINE { sum.word_[i] = words::add(a.word_[i], b.word_[i], carry); });
    return sum;
  }
  AXISCERT_WORDS_INLINE friend WideInteger operator-(const WideInteger& a, const WideInteger& b) {
    WideInteger difference = a;
    difference.template subtract<0>(b, ~std::uint64_t{0});
    return difference;
  }

  // Exact: the product is at most 2^(64 count - 1) 2^(64 others - 1), which fits count + others.
  template <std::size_t others>
  AXISCERT_WORDS_INLINE WideInteger<count + others> operator*(const WideInteger<others>& other) const {
    if constexpr (count + others == 2) {
      const auto word = [](std::uint64_t w) { return static_cast<Int128>(static_cast<std::int64_t>(w)); };
      return WideInteger<2>(word(word_[0]) * word(other.word_[0]));
    } else if constexpr (count + others <= 4) {
      return product(other);
    } else {
      return called_product(other);
    }
  }

 private:
  template <std::size_t>
  friend class WideInteger;
  WideInteger() = default;

  AXISCERT_WORDS_INLINE std::uint64_t sign_mask() const {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(word_[count - 1]) >> 63);
  }

  template <std::size_t others>
  AXISCERT_WORDS_INLINE WideInteger<count + others> product(const WideInteger<others>& other) const {
    WideInteger<count + others> result;
    result.set_unsigned_product(word_, other.word_);
    // Read as unsigned, a negative a is a + 2^(64 count): the product is too great by 2^(64 count) b, and likewise for
    // b. If both are negative it is also too great by 2^(64 (count + others)), which is 0 modulo the size of the
    // result.
    result.template subtract<count>(other, sign_mask());
    result.template subtract<others>(*this, other.sign_mask());
    return result;
  }
  // The product in a function of its own: the cost of a call is small beside that of so many words.
  template <std::size_t others>
  [[gnu::noinline]] WideInteger<count + others> called_product(const WideInteger<others>& other) const {
    return product(other);
  }

  template <std::size_t m, std::size_t n>
  AXISCERT_WORDS_INLINE void set_unsigned_product(const std::array<std::uint64_t, m>& a,
                                                  const std::array<std::uint64_t, n>& b) {
    words::for_each_index<m>([&](auto i) AXISCERT_WORDS_INLINE {
      std::uint64_t carry = 0;
      words::for_each_index<n>([&](auto j) AXISCERT_WORDS_INLINE {
        // At most (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1.
        UInt128 sum = static_cast<UInt128>(a[i]) * b[j] + carry;
        if constexpr (i > 0) sum += word_[i + j];
        word_[i + j] = static_cast<std::uint64_t>(sum);
        carry = static_cast<std::uint64_t>(sum >> 64);
      });
      word_[i + n] = carry;
    });
  }

  // Subtracts `number` from the words from index `from` on, as many as `number` has, if the mask is all ones; does
  // nothing if it is 0.
  template <std::size_t from, std::size_t n>
  AXISCERT_WORDS_INLINE void subtract(const WideInteger<n>& number, std::uint64_t mask) {
    static_assert(from + n == count);
    words::Carry borrow = 0;
    words::for_each_index<n>([&](auto i) AXISCERT_WORDS_INLINE {
      word_[from + i] = words::subtract(word_[from + i], number.word_[i] & mask, borrow);
    });
  }

  std::array<std::uint64_t, count> word_;
};

}  // namespace axiscert
