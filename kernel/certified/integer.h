// Integers of a fixed number of 64-bit words, two's complement, on the stack. The oracle has its own
// (exact/wide_integer.h): a type that both shared would be a bug that both shared.
#pragma once

#include <cstddef>
#include <cstdint>

namespace axiscert::certified {

__extension__ using UInt128 = unsigned __int128;

// No operation overflows where the callers keep to the sizes that they state.
template <std::size_t words>
struct Integer {
  std::uint64_t word[words];  // the least first

  bool is_negative() const noexcept { return (word[words - 1] >> 63) != 0; }
  bool is_zero() const noexcept {
    std::uint64_t any = 0;
    for (const std::uint64_t w : word) any |= w;
    return any == 0;
  }
  bool is_positive() const noexcept { return !is_negative() && !is_zero(); }

  friend Integer operator+(const Integer& a, const Integer& b) noexcept {
    Integer sum;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < words; ++i) {
      const UInt128 t = UInt128{a.word[i]} + b.word[i] + carry;
      sum.word[i] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    return sum;
  }
  friend Integer operator-(const Integer& a, const Integer& b) noexcept {
    Integer difference;
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < words; ++i) {
      const UInt128 t = UInt128{a.word[i]} - b.word[i] - borrow;
      difference.word[i] = static_cast<std::uint64_t>(t);
      borrow = static_cast<std::uint64_t>(t >> 64) & 1u;
    }
    return difference;
  }
};

// In full.
template <std::size_t m, std::size_t n>
Integer<m + n> operator*(const Integer<m>& a, const Integer<n>& b) noexcept {
  Integer<m + n> product{};
  for (std::size_t i = 0; i < m; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const UInt128 t = UInt128{a.word[i]} * b.word[j] + product.word[i + j] + carry;
      product.word[i + j] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    product.word[i + n] = carry;
  }
  // The words of a negative number are 2^(64 m) too much as an unsigned one.
  const auto subtract_above = [&product](std::size_t from, const auto& x, std::size_t count) {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const UInt128 t = UInt128{product.word[from + i]} - x.word[i] - borrow;
      product.word[from + i] = static_cast<std::uint64_t>(t);
      borrow = static_cast<std::uint64_t>(t >> 64) & 1u;
    }
  };
  if (a.is_negative()) subtract_above(m, b, n);
  if (b.is_negative()) subtract_above(n, a, m);
  return product;
}

// significand 2^shift, where that fits.
template <std::size_t words>
Integer<words> shifted(std::uint64_t significand, unsigned shift, bool negative) noexcept {
  Integer<words> x{};
  const std::size_t at = shift / 64;
  const unsigned by = shift % 64;
  if (at < words) x.word[at] = significand << by;
  if (by != 0 && at + 1 < words) x.word[at + 1] = significand >> (64 - by);
  return negative ? Integer<words>{} - x : x;
}

}  // namespace axiscert::certified
