// The properties of a query that shrinking goes by: its size to a reader, which is reduced, and the classes of its
// input, which are kept.
#pragma once

#include <compare>
#include <cstdint>
#include <string_view>
#include <vector>

#include "fuzz/queries/query_shape.h"
#include "kernel/query.h"

namespace axiscert {
// Compared from the first member to the last. All are natural numbers, so a sequence of decreasing sizes is finite.
struct QuerySize {
  int nonzero = 0;     // numbers that are not zero, including a sphere's centre: at the origin it has three fewer
  int bits = 0;        // significant bits of all of them: from the first set bit to the last
  int exponents = 0;   // the sum of |exponent of the first bit|
  int magnitudes = 0;  // different nonzero absolute values
  int negatives = 0;   // sign bits, including those of zeros
  int places = 0;      // the sum of the columns of the numbers that are not zero, the first at 0
  auto operator<=>(const QuerySize&) const = default;
};

// The size of a query of any predicate with finite numbers.
QuerySize size_of(const Numbers<float>& q);
QuerySize size_of(const Numbers<double>& q);

// A finite nonzero number as +-digits 2^exponent with odd digits.
struct BinaryDigits {
  std::uint64_t digits;
  int exponent;
};
BinaryDigits binary_digits(double x);

// The classes of a query's input that a smaller one keeps.

// The names of the definitions that a valid query of this entry meets, in their order; the first is its class. They are
// the predicate's own (fuzz/queries/capabilities.h) or, where it has none, these, which its description and its
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
