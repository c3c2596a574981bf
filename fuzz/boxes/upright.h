// Parts of the families of boxes by two corners: such a box of a centre and half extents, and a family of two boxes of
// which one or both are given so.
#pragma once

#include "fuzz/boxes/parts.h"

namespace axiscert::boxes {

// The corners of an upright box, each rounded once.
template <template <class> class Box, class Real>
CornersBox<Real> corners_of_upright(const Box<Real>& box) {
  const Vec3<Real> half{box.half[0], box.half[1], box.half[2]};
  return {box.centre - half, box.centre + half};
}
template <class Real>
CornersPair<Real> by_corners(const BoxPair<Real>& q) {
  return {corners_of_upright(q.a), corners_of_upright(q.b)};
}

// A box along the axes and another, as a pair of quaternions of which A's is 1.
template <class Real>
MixedPair<Real> with_corners(const TurnedPair<Real>& q) {
  return {corners_of_upright(q.a), q.b};
}
template <class Made, class Entry = MinmaxBoxes>
constexpr Family upright_family(std::string_view name, const Situation& situation, std::string_view purpose,
                                bool exact_arithmetic = false) {
  return family_in_entry<Made, Entry>(name, situation, purpose, exact_arithmetic);
}

}  // namespace axiscert::boxes
