// The sixteen exact signs by integers.
#pragma once

#include <optional>

#include "exact/sphere_triangle/filters/signs.h"
#include "kernel/query.h"

namespace axiscert {

// The signs of the published comparisons of a valid query, where its numbers are multiples of some 2^k and less than
// 2^(k + 126), and the differences v - p and the radius have `greatest_grid_bits` bits at most once divided by the
// greatest power of two that divides them all, or would but for a tiny radius: integers of a few words
// (exact/numbers/wide_integer.h). Otherwise nothing. Never throws, allocates or rounds; no subnormal may be taken for
// zero.
template <class Real>
std::optional<Signs> grid_signs(const Query<Real>& q);

// The same of every valid query: in as many words as it needs (exact/numbers/limb_integer.h).
template <class Real>
Signs integer_signs(const Query<Real>& q);

// The bits of the greatest of the nine differences and r in units of the greatest power of two that divides them all;
// nothing where the numbers lie too far apart. Queries to grid_bits(words) are decided in integers of that many words.
template <class Real>
std::optional<int> bits_on_grid(const Query<Real>& q);

// In integers of `words` words at degree 2, twice and three times as many at degrees 4 and 6
// (exact/sphere_triangle/filters/gram.h has the bounds).
constexpr int grid_bits(int words) { return 32 * words - 3; }
inline constexpr int most_grid_words = 4;
inline constexpr int greatest_grid_bits = grid_bits(most_grid_words);

}  // namespace axiscert
