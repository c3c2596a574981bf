// Enums as indices: the number of an enum's enumerators, and an array with one element for each of them.
#pragma once

#include <cstddef>
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

}  // namespace axiscert
