// The steps by which a query is shrunk. A step need not preserve anything: the walk measures its effect.
#pragma once

#include <optional>
#include <vector>

#include "fuzz/queries/query_shape.h"

namespace axiscert {

enum class MoveKind : std::uint8_t {
  translate,   // all points by minus point i, along axis j or, for j = the number of axes, along all
  zero,        // numbers i and j (which may be the same)
  flatten,     // coordinate i of all points and directions is zero
  round_all,   // all numbers to i significant bits, to nearest
  copy_point,  // point i becomes point j
  align,       // vertex i goes to the line through the last point P and vertex |j| % n of n, |j| / n - 3 binary orders
               // farther from P, on its side or, where j < 0, on the other one
  copy,        // number i becomes number j
  copy_negated,     // number i becomes minus number j
  scale_all,        // all numbers by the power of two that brings number i to [1, 2)
  scale_point,      // point i by 2^j, with the last point unchanged
  scale_axis,       // coordinate i of all points and directions by 2^j
  centre,           // number i to [1, 2) by a power of two
  scale,            // number i by 2^j
  round_down,       // number i to j significant bits, towards zero
  round_up,         // the same, away from zero
  reflect,          // coordinate i of all points and directions changes its sign
  negate,           // number i
  swap_axes,        // coordinates i and j of all points and directions
  swap_points,      // points i and j
  trade_down,       // number i to one significant bit less, towards zero, and number j by a unit of its last
                    // significant bit; -1-j for the other direction
  trade_up,         // the same, away from zero
  nudge,            // number i by j floats
  zero_direction,   // direction i
  scale_direction,  // direction i by 2^j
  along,            // the last point by direction i times 2^j
  reverse,          // the last point goes to the end of direction i, which changes its sign
  between,          // direction i becomes the difference of points j / n and j % n of n
  upright,          // frame i becomes the world's axes
  copy_frame,       // frame i becomes frame j
  into_frame,  // all points, as seen from the first, and all frames are turned into frame i, which becomes the world's
               // axes
};

struct Move {
  MoveKind kind;
  int i, j;
};

// The moves that can make a query of this shape smaller, from the largest to the smallest.
template <class Real>
std::vector<Move> moves(const QueryShape& shape);
// The moves that repair the effect of another one.
std::vector<Move> nudges(const QueryShape& shape);
// Empty if the move has no meaning (rounding to more bits than there are) or the result may not be a valid query.
template <class Real>
std::optional<Numbers<Real>> moved(const QueryShape& shape, const Numbers<Real>& q, const Move& move);

}  // namespace axiscert
