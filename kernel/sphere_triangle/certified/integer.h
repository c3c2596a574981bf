// Integers of a fixed number of 64-bit words, two's complement, on the stack. The oracle has its own type
// (exact/numbers/wide_integer.h): a fault in a shared type would be in both.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace axiscert::certified {
__extension__ using UInt128 = unsigned __int128;
__extension__ using Int128 = __int128;

// No operation overflows if the callers keep to the sizes that they state. Integers of one or two words are the
// compiler's own; signs are applied as masks, because a branch on them would be mispredicted half of the time.
template <std::size_t words>
struct Integer {
  static constexpr std::size_t size = words;
  std::uint64_t word[words];  // the least significant first

  std::uint64_t sign_mask() const noexcept { return ~((word[words - 1] >> 63) - 1); }  // all ones if negative
  bool is_negative() const noexcept { return (word[words - 1] >> 63) != 0; }
  bool is_zero() const noexcept {
    std::uint64_t any = 0;
    for (const std::uint64_t w : word) any |= w;
    return any == 0;
  }
  bool is_positive() const noexcept { return !is_negative() && !is_zero(); }

  // For one or two words.
  static Integer of(UInt128 x) noexcept {
    static_assert(words <= 2);
    Integer made;
    for (std::size_t i = 0; i < words; ++i) made.word[i] = static_cast<std::uint64_t>(x >> (64 * i));
    return made;
  }
  UInt128 native() const noexcept {
    static_assert(words <= 2);
    if constexpr (words == 1) return static_cast<UInt128>(static_cast<Int128>(static_cast<std::int64_t>(word[0])));
    else return (UInt128{word[1]} << 64) | word[0];
  }

  friend Integer operator+(const Integer& a, const Integer& b) noexcept {
    if constexpr (words == 1) return {{a.word[0] + b.word[0]}};
    else if constexpr (words == 2) return of(a.native() + b.native());
    else {
      Integer sum;
      std::uint64_t carry = 0;
      for (std::size_t i = 0; i < words; ++i) {
        const UInt128 t = UInt128{a.word[i]} + b.word[i] + carry;
        sum.word[i] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      return sum;
    }
  }
  friend Integer operator-(const Integer& a, const Integer& b) noexcept {
    if constexpr (words == 1) return {{a.word[0] - b.word[0]}};
    else if constexpr (words == 2) return of(a.native() - b.native());
    else {
      Integer difference;
      std::uint64_t borrow = 0;
      for (std::size_t i = 0; i < words; ++i) {
        const UInt128 t = UInt128{a.word[i]} - b.word[i] - borrow;
        difference.word[i] = static_cast<std::uint64_t>(t);
        borrow = static_cast<std::uint64_t>(t >> 64) & 1u;
      }
      return difference;
    }
  }
};

// a b, which fits in the words of `Result`.
template <class Result, std::size_t m, std::size_t n>
Result product(const Integer<m>& a, const Integer<n>& b) noexcept {
  constexpr std::size_t words = Result::size;
  static_assert(words <= m + n);
  if constexpr (words <= 2) {
    return Integer<words>::of(a.native() * b.native());
  } else if constexpr (m == 2 && n == 2) {
    const UInt128 low = UInt128{a.word[0]} * b.word[0];
    const UInt128 one = UInt128{a.word[0]} * b.word[1] + (low >> 64);
    const UInt128 two = UInt128{a.word[1]} * b.word[0] + static_cast<std::uint64_t>(one);
    UInt128 high = UInt128{a.word[1]} * b.word[1] + (one >> 64) + (two >> 64);
    // Read as an unsigned number, the words of a negative number are too great by 2^128.
    high -= (a.is_negative() ? b.native() : 0) + (b.is_negative() ? a.native() : 0);
    Integer<words> result{
        {static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(two), static_cast<std::uint64_t>(high)}};
    if constexpr (words == 4) result.word[3] = static_cast<std::uint64_t>(high >> 64);
    return result;
  } else {
    Integer<words> result{};
    for (std::size_t i = 0; i < m; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < n && i + j < words; ++j) {
        const UInt128 t = UInt128{a.word[i]} * b.word[j] + result.word[i + j] + carry;
        result.word[i + j] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      if (i + n < words) result.word[i + n] = carry;
    }
    // Read as an unsigned number, the words of a negative number are too great by 2^(64 m).
    const auto subtract_above = [&result](std::size_t from, const auto& x, std::size_t count, std::uint64_t mask) {
      std::uint64_t borrow = 0;
      for (std::size_t i = 0; i < count && from + i < words; ++i) {
        const UInt128 t = UInt128{result.word[from + i]} - (x.word[i] & mask) - borrow;
        result.word[from + i] = static_cast<std::uint64_t>(t);
        borrow = static_cast<std::uint64_t>(t >> 64) & 1u;
      }
    };
    subtract_above(m, b, n, a.sign_mask());
    subtract_above(n, a, m, b.sign_mask());
    return result;
  }
}

// significand 2^shift, which has to fit.
template <class Result>
Result shifted(std::uint64_t significand, unsigned shift, bool negative) noexcept {
  constexpr std::size_t words = Result::size;
  Result x{};
  const std::size_t at = shift / 64;
  const unsigned by = shift % 64;
  if (at < words) x.word[at] = significand << by;
  if (by != 0 && at + 1 < words) x.word[at + 1] = significand >> (64 - by);
  return negative ? Result{} - x : x;
}

// A double split into significand and exponent.

// A finite double as significand 2^exponent; the last `zeros` bits of the significand are zero.
struct Dyadic {
  std::uint64_t significand;
  int exponent, zeros;
  bool negative;

  explicit Dyadic(double x) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int stored = static_cast<int>((bits >> 52) & 0x7ff), is_normal = stored != 0;
    significand = (bits & ((std::uint64_t{1} << 52) - 1)) | (static_cast<std::uint64_t>(is_normal) << 52);
    exponent = stored - is_normal - 1074;
    zeros = std::countr_zero(significand | (std::uint64_t{1} << 63));
    negative = (bits >> 63) != 0;
  }
  int top() const noexcept { return exponent + static_cast<int>(std::bit_width(significand)); }
};

}  // namespace axiscert::certified
