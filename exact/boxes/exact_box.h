// Boxes over the rationals, made of a query's numbers without rounding.
#pragma once

#include "exact/boxes/nearest.h"
#include "kernel/boxes/turned.h"

namespace axiscert::boxes {

using ExactBox = OrientedBox<Rational>;
using ExactPair = BoxPair<Rational>;

// Precondition: the numbers are finite, and no quaternion is 0.
ExactPair exact_pair(const BoxPair<double>& q);
ExactPair exact_pair(const TurnedPair<double>& q);

// Its eight corners, some of them equal where a half extent is 0.
Hull corners_of(const ExactBox& box);

// The determinant of its axes: 0 where they are dependent, and the numbers are not a box.
Rational determinant(const ExactBox& box);

}  // namespace axiscert::boxes
