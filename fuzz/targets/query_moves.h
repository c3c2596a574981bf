// The kernel target's inputs: what a fuzzer's bytes mean, and changes that respect the structure of floating-point
// numbers. Random bytes are nearly always far from any boundary, and a flipped bit of an exponent leaves the boundary
// that was found.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "fuzz/search/moves.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::fuzzing {
// The meaning of a fuzzer's bytes for the kernel target: a kernel, and a query in one of the two precisions.

// Byte 0: bit 0 is the precision, 0 for binary32, 1 for binary64. Byte 1: the kernel, modulo the number of kernels.
// Then the thirteen numbers in the order of every column, as in memory (little-endian): 54 or 106 bytes in all.
struct FuzzedQuery {
  std::uint8_t kernel = 0;
  std::variant<Query<float>, Query<double>> query;
};
inline constexpr std::size_t greatest_size = 2 + coordinate_count * sizeof(double);

// Any bytes are accepted: missing ones are zero, and surplus ones are ignored.
FuzzedQuery fuzzed_query(std::span<const std::uint8_t> bytes);
std::vector<std::uint8_t> bytes_of(const FuzzedQuery& fuzzed);

enum class QueryMove : std::uint8_t {
  ulps,       // moves a number to one of its neighbours: 1 to 2^digits ulps away, near ones more often
  exponent,   // multiplies a number, a point or all numbers by a power of two
  sign,       // negates a number, an axis or everything
  special,    // sets a zero, the least or greatest subnormal or normal number, a power of two, an infinity or a NaN
  copy,       // sets another coordinate's number, or its negative
  repeat,     // moves a vertex to another one, to the line of two others, or to the centre
  swap,       // swaps two vertices, or two axes
  tie,        // moves the radius, or a coordinate of the centre, to a tie of a comparison or a few ulps from it
  precision,  // keeps the numbers but changes the precision: rounded to nearest, or widened
  kernel,     // chooses another kernel
};
inline constexpr std::size_t query_move_count = 10;
inline constexpr EnumArray<QueryMove, std::string_view, query_move_count> query_move_names = {
    "ulps", "exponent", "sign", "special", "copy", "repeat", "swap", "tie", "precision", "kernel"};

// Keeps the numbers but changes the precision: rounded to nearest, or widened.
void change_precision(FuzzedQuery& fuzzed);

// Makes the move; the query may stay as it is if the move finds nothing to change.
void apply(QueryMove move, Dice& dice, FuzzedQuery& fuzzed);

// Makes one to four moves, determined by the seed alone.
void mutate(FuzzedQuery& fuzzed, std::uint32_t seed);
// Takes each point and the radius from one of the two; precision and kernel are those of the first.
void cross(FuzzedQuery& fuzzed, const FuzzedQuery& other, std::uint32_t seed);

}  // namespace axiscert::fuzzing
