// The parts of a query by the description of its predicate: which numbers are points, directions and lengths.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "kernel/query.h"
#include "kernel/predicate.h"

namespace axiscert {

struct QueryShape {
  std::size_t numbers = 0, axes = 0;    // axes: numbers of a point
  std::vector<std::size_t> points;      // the first column of each; the last point is the one that the others are seen
                                        // from, as a sphere's centre
  std::vector<std::size_t> directions;  // the same of displacements, which a translation leaves as they are
  std::vector<std::size_t> frames;  // the first column of each three directions that are named X.0, X.1 and X.2: the
                                    // axes of a box; they are among the directions too
  std::array<bool, most_columns> is_length{};

  std::size_t vertices() const { return points.empty() ? 0 : points.size() - 1; }
};

// The points are the groups of coordinates of the size of the first such group, and directions have this size too;
// numbers of other groups are moved one by one.
QueryShape shape_of(const PredicateEntry& entry);

// Whether the frame from column `first` on is a rotation but for some roundings, perhaps of the other handedness: every
// dot product of two of its vectors within eight halves of an ulp of 1 of 1 or 0, as computed.
template <class Real>
bool is_nearly_rotation(const Numbers<Real>& q, std::size_t first);
// Makes it one, by Gram and Schmidt in binary64, rounded once; a frame that has no three independent axes becomes the
// world's axes. Sums, products, quotients and roots alone: the same everywhere.
template <class Real>
void make_rotation(Numbers<Real>& q, std::size_t first);

// Whether all numbers are finite and no length is negative: what every predicate asks of a query.
template <class Real>
bool may_be_valid(const QueryShape& shape, const Numbers<Real>& q);

}  // namespace axiscert
