// A depth before it is rounded: |sqrt(dd) - r| / sqrt(ss), the difference of two lengths over a third.
#pragma once

#include "exact/numbers/rational.h"

namespace axiscert {

// dd, r >= 0, and ss > 0.
struct ExactDepth {
  Rational dd, r, ss;
};
// Rounded once, to the nearest binary64.
double rounded_depth(const ExactDepth& depth);
// The sign of x - y.
int compare(const ExactDepth& x, const ExactDepth& y);

}  // namespace axiscert
