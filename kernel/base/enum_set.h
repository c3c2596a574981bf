// A set of enumerators in one word.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <initializer_list>

#include "kernel/base/bits.h"
#include "kernel/base/enum_array.h"

namespace axiscert {

// Bit i of the word is the enumerator with value i. Every operation is the one on the word that it looks like.
template <Enumeration Enum, std::unsigned_integral Bits>
class EnumSet {
  static_assert(enum_count<Enum> <= sizeof(Bits) * 8, "more enumerators than bits");

 public:
  // Visits the members in the order of the enumerators.
  class Iterator {
   public:
    using value_type = Enum;
    using difference_type = std::ptrdiff_t;
    constexpr Iterator() = default;
    constexpr explicit Iterator(Bits rest) : rest_(rest) {}
    constexpr Enum operator*() const { return static_cast<Enum>(first_bit(rest_)); }
    constexpr Iterator& operator++() {
      rest_ = static_cast<Bits>(rest_ & (rest_ - 1));
      return *this;
    }
    constexpr Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator&) const = default;

   private:
    Bits rest_ = 0;
  };

  constexpr EnumSet() = default;
  constexpr EnumSet(std::initializer_list<Enum> members) {
    for (const Enum member : members) insert(member);
  }
  // The inverse of bits().
  static constexpr EnumSet from_bits(Bits bits) {
    EnumSet set;
    set.bits_ = bits;
    return set;
  }

  constexpr bool contains(Enum which) const { return has_bit(bits_, which); }
  constexpr bool contains_all(EnumSet other) const { return (other & *this) == other; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr std::size_t size() const { return static_cast<std::size_t>(std::popcount(bits_)); }
  constexpr Bits bits() const { return bits_; }  // for formats of files and streams
  constexpr Iterator begin() const { return Iterator(bits_); }
  constexpr Iterator end() const { return Iterator(); }

  constexpr void insert(Enum which) { bits_ |= one_bit<Bits>(which); }
  constexpr void erase(Enum which) { bits_ = static_cast<Bits>(bits_ & ~one_bit<Bits>(which)); }
  constexpr EnumSet& operator|=(EnumSet other) { return *this = *this | other; }
  constexpr EnumSet& operator&=(EnumSet other) { return *this = *this & other; }

  friend constexpr EnumSet operator|(EnumSet a, EnumSet b) { return from_bits(static_cast<Bits>(a.bits_ | b.bits_)); }
  friend constexpr EnumSet operator&(EnumSet a, EnumSet b) { return from_bits(static_cast<Bits>(a.bits_ & b.bits_)); }
  bool operator==(const EnumSet&) const = default;

 private:
  Bits bits_ = 0;
};

}  // namespace axiscert
