// The sixteen exact signs in integer arithmetic.
#pragma once

#include <optional>

#include "exact/sphere_triangle/oracles/signs.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// The signs of the published comparisons of a valid query, by integers of a few words (exact/numbers/wide_integer.h).
// Empty unless the numbers of the query are multiples of some 2^k and less than 2^(k + 126), and the differences v - p
// and the radius, divided by the greatest power of two that divides them all, have at most `greatest_grid_bits` bits,
// or would have but for a tiny radius. Never throws, allocates or rounds; the processor must not treat subnormals as
// zero.
template <class Real>
std::optional<Signs> grid_signs(const Query<Real>& q);

// The same signs for every valid query, in as many words as it needs (exact/numbers/limb_integer.h).
template <class Real>
Signs integer_signs(const Query<Real>& q);

// The bits of the greatest of the nine differences and r in units of the greatest power of two that divides them all;
// empty if the numbers lie too far apart. Queries of up to grid_bits(words) bits are decided in integers of that many
// words.
template <class Real>
std::optional<int> bits_on_grid(const Query<Real>& q);

// The bits that integers of `words` words at degree 2, and twice and three times as many at degrees 4 and 6, can handle
// (exact/sphere_triangle/oracles/gram.h has the bounds).
constexpr int grid_bits(int words) { return 32 * words - 3; }
inline constexpr int most_grid_words = 4;
inline constexpr int greatest_grid_bits = grid_bits(most_grid_words);

}  // namespace axiscert
