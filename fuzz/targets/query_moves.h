// How the kernel target goes from one input to the next: moves that know what a floating-point number is. Random bytes
// are nearly always far from any boundary, and a flipped bit of an exponent loses the one that was found.
#pragma once

#include <array>
#include <string_view>

#include "fuzz/search/dice.h"
#include "fuzz/targets/fuzzed_query.h"

namespace axiscert::fuzzing {

enum class QueryMove : std::uint8_t {
  ulps,       // a number to one of its neighbours: 1 to 2^digits ulps away, near ones more often
  exponent,   // a number, a point or all of them times a power of two
  sign,       // of a number, an axis or all of them
  special,    // a zero, the least and greatest subnormal and normal numbers, a power of two, an infinity, a NaN
  copy,       // another coordinate's number, or its negative
  repeat,     // a vertex where another is, on the line of two others, or at the centre
  swap,       // two vertices, or two axes
  tie,        // the radius, or a coordinate of the centre, to where a comparison is a tie; a few ulps from it
  precision,  // the same numbers in the other precision: rounded to nearest, or widened
  kernel,     // another one
};
inline constexpr std::size_t query_move_count = 10;
inline constexpr std::array<std::string_view, query_move_count> query_move_names = {
    "ulps", "exponent", "sign", "special", "copy", "repeat", "swap", "tie", "precision", "kernel"};

// The same numbers in the other precision: rounded to nearest, or widened.
void change_precision(FuzzedQuery& fuzzed);

// A move may leave the query as it is, where it has nothing to go on.
void apply(QueryMove move, Dice& dice, FuzzedQuery& fuzzed);

// One to four moves, drawn from the seed alone.
void mutate(FuzzedQuery& fuzzed, std::uint32_t seed);
// Each point and the radius from one of the two. The first one's precision and kernel.
void cross(FuzzedQuery& fuzzed, const FuzzedQuery& other, std::uint32_t seed);

}  // namespace axiscert::fuzzing
