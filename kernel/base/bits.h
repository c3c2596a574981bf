// Words whose bit i is thing i of a list that is only known while axiscert runs, such as comparison i of a predicate's
// description. Where the things are an enum, EnumSet (enum_set.h) says more.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>

#include "kernel/base/enum_array.h"

namespace axiscert {

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

}  // namespace axiscert
