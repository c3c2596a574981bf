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

#include "kernel/per_target.h"

#define AXISCERT_INLINE_LAMBDA __attribute__((always_inline))

namespace axiscert {

__extension__ typedef __int128 Int128;  // ISO C++ has no name for it
__extension__ typedef unsigned __int128 UInt128;

namespace words {

// a + b + carry and a - b - borrow modulo 2^64; the carry out is 0 or 1. Written for the compiler to keep the carry in
// a flag, which it does not do for a carry that it sees as a number.
#ifdef __x86_64__
using Carry = unsigned char;
AXISCERT_INLINE std::uint64_t add(std::uint64_t a, std::uint64_t b, Carry& carry) {
  unsigned long long sum;
  carry = _addcarry_u64(carry, a, b, &sum);
  return sum;
}
AXISCERT_INLINE std::uint64_t subtract(std::uint64_t a, std::uint64_t b, Carry& borrow) {
  unsigned long long difference;
  borrow = _subborrow_u64(borrow, a, b, &difference);
  return difference;
}
#else
using Carry = std::uint64_t;
AXISCERT_INLINE std::uint64_t add(std::uint64_t a, std::uint64_t b, Carry& carry) {
  const UInt128 sum = static_cast<UInt128>(a) + b + carry;
  carry = static_cast<std::uint64_t>(sum >> 64);
  return static_cast<std::uint64_t>(sum);
}
AXISCERT_INLINE std::uint64_t subtract(std::uint64_t a, std::uint64_t b, Carry& borrow) {
  const UInt128 difference = static_cast<UInt128>(a) - b - borrow;
  borrow = static_cast<std::uint64_t>(difference >> 64) & 1u;
  return static_cast<std::uint64_t>(difference);
}
#endif

// Calls f with each index as a constant: a loop that is unrolled before the optimiser starts.
template <std::size_t count, class F>
AXISCERT_INLINE void for_each_index(F&& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>)
      AXISCERT_INLINE_LAMBDA { (f(std::integral_constant<std::size_t, i>{}), ...); }(std::make_index_sequence<count>());
}

}  // namespace words

// Words are unsigned, least first, and sums and differences are taken modulo 2^(64 words): right wherever the result
// lies in [-2^(64 words - 1), 2^(64 words - 1)), whatever the partial sums did. That it does is the caller's to show.
template <std::size_t count>
class WideInteger {
 public:
  AXISCERT_INLINE explicit WideInteger(std::int64_t x) {
    word_.fill(x < 0 ? ~std::uint64_t{0} : 0);
    word_[0] = static_cast<std::uint64_t>(x);
  }
  AXISCERT_INLINE explicit WideInteger(Int128 x)
    requires(count >= 2)
      : WideInteger(static_cast<std::int64_t>(x >> 64)) {
    word_[1] = word_[0];
    word_[0] = static_cast<std::uint64_t>(x);
  }
  // The low words of a number that fits them.
  template <std::size_t others>
    requires(others > count)
  AXISCERT_INLINE explicit WideInteger(const WideInteger<others>& x) {
    words::for_each_index<count>([&](auto i) AXISCERT_INLINE_LAMBDA { word_[i] = x.word_[i]; });
  }

  AXISCERT_INLINE bool is_negative() const { return (word_[count - 1] >> 63) != 0; }
  AXISCERT_INLINE bool is_zero() const {
    std::uint64_t any = 0;
    words::for_each_index<count>([&](auto i) AXISCERT_INLINE_LAMBDA { any |= word_[i]; });
    return any == 0;
  }

  AXISCERT_INLINE friend WideInteger operator+(const WideInteger& a, const WideInteger& b) {
    WideInteger sum;
    words::Carry carry = 0;
    words::for_each_index<count>(
        [&](auto i) AXISCERT_INLINE_LAMBDA { sum.word_[i] = words::add(a.word_[i], b.word_[i], carry); });
    return sum;
  }
  AXISCERT_INLINE friend WideInteger operator-(const WideInteger& a, const WideInteger& b) {
    WideInteger difference = a;
    difference.template subtract<0>(b, ~std::uint64_t{0});
    return difference;
  }

  // Exact: the product is at most 2^(64 count - 1) 2^(64 others - 1), which fits count + others.
  template <std::size_t others>
  AXISCERT_INLINE WideInteger<count + others> operator*(const WideInteger<others>& other) const {
    WideInteger<count + others> result;
    if constexpr (count + others == 2) {
      const Int128 p =
          static_cast<Int128>(static_cast<std::int64_t>(word_[0])) * static_cast<std::int64_t>(other.word_[0]);
      result.word_ = {static_cast<std::uint64_t>(p), static_cast<std::uint64_t>(p >> 64)};
    } else {
      result.set_unsigned_product(word_, other.word_);
      // Read as unsigned, a negative a is a + 2^(64 count): the product has 2^(64 count) b too much, and likewise for
      // b. Where both are negative it has 2^(64 (count + others)) too much as well, which is none.
      result.template subtract<count>(other, sign_mask());
      result.template subtract<others>(*this, other.sign_mask());
    }
    return result;
  }

 private:
  template <std::size_t>
  friend class WideInteger;
  WideInteger() = default;

  AXISCERT_INLINE std::uint64_t sign_mask() const {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(word_[count - 1]) >> 63);
  }

  template <std::size_t m, std::size_t n>
  AXISCERT_INLINE void set_unsigned_product(const std::array<std::uint64_t, m>& a,
                                            const std::array<std::uint64_t, n>& b) {
    words::for_each_index<m>([&](auto i) AXISCERT_INLINE_LAMBDA {
      std::uint64_t carry = 0;
      words::for_each_index<n>([&](auto j) AXISCERT_INLINE_LAMBDA {
        // At most (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1.
        UInt128 sum = static_cast<UInt128>(a[i]) * b[j] + carry;
        if constexpr (i > 0) sum += word_[i + j];
        word_[i + j] = static_cast<std::uint64_t>(sum);
        carry = static_cast<std::uint64_t>(sum >> 64);
      });
      word_[i + n] = carry;
    });
  }

  // Subtracts the number from the words from `from` on, which are as many as its own, if the mask is all ones; nothing
  // if it is 0.
  template <std::size_t from, std::size_t n>
  AXISCERT_INLINE void subtract(const WideInteger<n>& number, std::uint64_t mask) {
    static_assert(from + n == count);
    words::Carry borrow = 0;
    words::for_each_index<n>([&](auto i) AXISCERT_INLINE_LAMBDA {
      word_[from + i] = words::subtract(word_[from + i], number.word_[i] & mask, borrow);
    });
  }

  std::array<std::uint64_t, count> word_;
};

}  // namespace axiscert
