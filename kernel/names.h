// The vocabulary of every predicate: verdicts, conventions, precisions, bits of comparisons. A predicate's own names
// are in its description (kernel/predicate.h).
#pragma once

#include <cstdint>
#include <string_view>

#include "kernel/base/enums.h"

namespace axiscert {

// Bit i is comparison i, or clause i, of the predicate's description.
using ComparisonBits = std::uint64_t;
using ClauseBits = std::uint64_t;

// `contact` and `separated` are 0 and 1 so that a separation bit is a verdict. A kernel never answers `unanswered`: it
// means that the kernel crashed, hung, or was not asked because of that.
enum class Verdict : std::uint8_t { contact = 0, separated = 1, undecided = 2, invalid = 3, unanswered = 4 };
template <>
inline constexpr std::size_t enum_count<Verdict> = 5;
inline constexpr EnumArray<Verdict, std::string_view> verdict_names = {"contact", "separated", "undecided", "invalid",
                                                                       "unanswered"};
constexpr std::string_view name(Verdict v) { return verdict_names[v]; }

// The answer that a kernel means to give where the two touch; with `either`, neither answer is
// wrong.
enum class TouchingPolicy : std::uint8_t { contact, separated, either };
template <>
inline constexpr std::size_t enum_count<TouchingPolicy> = 3;
inline constexpr EnumArray<TouchingPolicy, std::string_view> touching_names = {"contact", "separated", "either"};
constexpr std::string_view name(TouchingPolicy t) { return touching_names[t]; }

enum class Precision : std::uint8_t { binary32, binary64 };
template <>
inline constexpr std::size_t enum_count<Precision> = 2;
inline constexpr EnumArray<Precision, std::string_view> precision_names = {"binary32", "binary64"};
constexpr std::string_view name(Precision p) { return precision_names[p]; }
template <class Real>
inline constexpr Precision precision_of = sizeof(Real) == 4 ? Precision::binary32 : Precision::binary64;

// The relation that a kernel's comparisons use where its formulae leave the choice: of sphere-triangle's, the nine side
// comparisons; the seven radius comparisons use `>` in each case. `not_less` is `>=` on hardware without that
// instruction, !(rhs > lhs): the same on numbers, but it holds if a side is NaN.
enum class Strictness : std::uint8_t { strict, nonstrict, not_less };
template <>
inline constexpr std::size_t enum_count<Strictness> = 3;
inline constexpr EnumArray<Strictness, std::string_view> strictness_names = {"strict", "nonstrict", "not_less"};
constexpr std::string_view name(Strictness s) { return strictness_names[s]; }

}  // namespace axiscert
