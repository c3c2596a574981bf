// The classes of a query's input that a smaller one keeps.
#pragma once

#include <string_view>
#include <vector>

#include "fuzz/queries/query_shape.h"

namespace axiscert {

// The names of the definitions that a valid query of this entry meets, in their order; the first is its class. They are
// the predicate's own (fuzz/queries/input_classes.h) or, where it has none, these, which its description and its
// oracles serve, decided exactly:
//
//   tie        the depth is 0
//   near_tie   the depth, rounded once, is at most 64 u
//   scale      L is not 0 and outside the lengths for which formulae of degree 6 keep to the normal numbers
//   repeated   two points are equal
//   collinear  the points but the last, three or more, are on a line
//   still      a direction is 0
//   parallel   a direction is not 0 and in the plane or line of the points but the last
//   point      a length is 0
//   far        a coordinate of a point is at least 64 L: the origin is far away
//   sheared    the axes of a box are not a rotation but for roundings (is_nearly_rotation)
//   ordinary   none of these
//
// L is the greatest |number| of the points, as seen from the last of them, the directions and the lengths.
template <class Real>
std::vector<std::string_view> classes_of(const Predicate& predicate, const Numbers<Real>& q, std::size_t entry = 0);

}  // namespace axiscert
