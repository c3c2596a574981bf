// Enums as indices, names and bits: an array with an element for each enumerator, words of bits, sets of enumerators.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <type_traits>

namespace axiscert {
template <class Enum>
concept Enumeration = std::is_enum_v<Enum>;

// The number of enumerators of an enum whose values are 0, 1, 2, ...; said once, beside the enum:
//   template <>
//   inline constexpr std::size_t enum_count<Axis> = 7;
template <Enumeration Enum>
inline constexpr std::size_t enum_count = 0;

template <Enumeration Enum>
constexpr std::size_t index_of(Enum which) {
  return static_cast<std::size_t>(which);
}

// An element for each enumerator, in their order, indexed by the enumerator. Loops over several lists at once may use
// its number. An aggregate, as std::array is; an index has to be less than N.
template <Enumeration Enum, class T, std::size_t N = enum_count<Enum>>
struct EnumArray {
  static_assert(N > 0, "the number of enumerators is not known: specialize enum_count beside the enum");

  constexpr T& operator[](Enum which) { return values[index_of(which)]; }
  constexpr const T& operator[](Enum which) const { return values[index_of(which)]; }
  constexpr T& operator[](std::size_t i) { return values[i]; }
  constexpr const T& operator[](std::size_t i) const { return values[i]; }

  static constexpr std::size_t size() { return N; }
  constexpr T* data() { return values; }
  constexpr const T* data() const { return values; }
  constexpr T* begin() { return values; }
  constexpr const T* begin() const { return values; }
  constexpr T* end() { return values + N; }
  constexpr const T* end() const { return values + N; }

  bool operator==(const EnumArray&) const = default;

  T values[N];
};

// The enumerators themselves, in their order: for (const Axis axis : enumerators<Axis>).
template <Enumeration Enum>
struct Enumerators {
  struct Iterator {
    std::size_t next;
    constexpr Enum operator*() const { return static_cast<Enum>(next); }
    constexpr Iterator& operator++() {
      ++next;
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };
  static constexpr Iterator begin() { return {0}; }
  static constexpr Iterator end() { return {enum_count<Enum>}; }
};
template <Enumeration Enum>
inline constexpr Enumerators<Enum> enumerators;

// The enumerator whose name() is the text; nothing where there is none.
template <Enumeration Enum>
constexpr std::optional<Enum> enumerator_named(std::string_view text) {
  for (const Enum each : enumerators<Enum>) {
    if (name(each) == text) return each;
  }
  return std::nullopt;
}

// Words whose bit i is thing i of a list that is only known while axiscert runs, such as comparison i of a predicate's
// description. Where the things are an enum, EnumSet below says more.

// All of these need an index less than the number of bits.
constexpr bool has_bit(std::unsigned_integral auto bits, std::size_t i) { return ((bits >> i) & 1u) != 0; }
template <Enumeration Enum>
constexpr bool has_bit(std::unsigned_integral auto bits, Enum which) {
  return has_bit(bits, index_of(which));
}

// The word with that bit alone.
template <std::unsigned_integral Bits>
constexpr Bits one_bit(std::size_t i) {
  return static_cast<Bits>(Bits{1} << i);
}
template <std::unsigned_integral Bits, Enumeration Enum>
constexpr Bits one_bit(Enum which) {
  return one_bit<Bits>(index_of(which));
}

// one_bit(i) where the condition holds, else 0, without a branch.
template <std::unsigned_integral Bits>
constexpr Bits bit_if(bool condition, std::size_t i) {
  return static_cast<Bits>(Bits{condition} << i);
}

// The index of the lowest bit that is set; of 0, the number of bits.
constexpr std::size_t first_bit(std::unsigned_integral auto bits) {
  return static_cast<std::size_t>(std::countr_zero(bits));
}

// Calls visit(index) for each bit that is set, the lowest first.
template <std::unsigned_integral Bits, class Visit>
constexpr void for_each_bit(Bits bits, Visit&& visit) {
  for (; bits != 0; bits = static_cast<Bits>(bits & (bits - 1))) visit(first_bit(bits));
}

// A set of enumerators in one word.

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
