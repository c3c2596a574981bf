// The vocabulary of every test: verdicts, conventions, precisions, bits of comparisons. A test's own names are in its
// description (kernel/test.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace axiscert {

// Bit i is comparison i, or clause i, of the test's description.
using ComparisonBits = std::uint64_t;
using ClauseBits = std::uint64_t;

// `contact` and `separated` are 0 and 1 so that a separation bit is a verdict. A kernel never answers `unanswered`: it
// means that the kernel crashed, hung, or was not asked because of that.
enum class Verdict : std::uint8_t { contact = 0, separated = 1, undecided = 2, invalid = 3, unanswered = 4 };
inline constexpr std::array<std::string_view, 5> verdict_names = {"contact", "separated", "undecided", "invalid",
                                                                  "unanswered"};
constexpr std::string_view name(Verdict v) { return verdict_names[static_cast<std::size_t>(v)]; }

// The answer that a kernel means to give where the two touch; with `either`, neither answer is
// wrong.
enum class Touching : std::uint8_t { contact, separated, either };
inline constexpr std::array<std::string_view, 3> touching_names = {"contact", "separated", "either"};
constexpr std::string_view name(Touching t) { return touching_names[static_cast<std::size_t>(t)]; }

enum class Precision : std::uint8_t { binary32, binary64 };
inline constexpr std::array<std::string_view, 2> precision_names = {"binary32", "binary64"};
constexpr std::string_view name(Precision p) { return precision_names[static_cast<std::size_t>(p)]; }
template <class Real>
inline constexpr Precision precision_of = sizeof(Real) == 4 ? Precision::binary32 : Precision::binary64;

}  // namespace axiscert
