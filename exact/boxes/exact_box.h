// Boxes over the rationals, made of a query's numbers without rounding.
#pragma once

#include "exact/boxes/nearest.h"
#include "exact/boxes/scaled.h"

namespace axiscert::boxes {

using ExactBox = OrientedBox<Rational>;
using ExactPair = BoxPair<Rational>;

// Precondition: the numbers are finite, and no quaternion is 0.
ExactPair exact_pair(const BoxPair<double>& q);
ExactPair exact_pair(const TurnedPair<double>& q);

}  // namespace axiscert::boxes
