// The depth of a wrong verdict, exact and rounded once.
#pragma once

#include <limits>

#include "exact/numbers/rational.h"

namespace axiscert {
// A depth before it is rounded: |sqrt(dd) - r| / sqrt(ss), the difference of two lengths over a third, or with r < 0
// their sum. dd >= 0, and ss > 0.
struct ExactDepth {
  Rational dd, r, ss;
};
// Both rounded once, to the nearest binary64: the depth, and the length |sqrt(dd) - r| in the query's unit, which is
// not above the greatest finite one.
double rounded_depth(const ExactDepth& depth);
double rounded_length(const ExactDepth& depth);
// The sign of x - y.
int compare(const ExactDepth& x, const ExactDepth& y);

// How deep a wrong verdict on one query is.

// The distance of a query from touching, relative to its scene: of sphere-triangle |d - r| / max(|A-P|, |B-P|, |C-P|,
// r). Exact, and so only computed where it could be kept.
class DepthOf {
 public:
  virtual double at_least() = 0;  // both certainly, of exactly() too
  virtual double at_most() = 0;
  virtual double exactly() = 0;  // rounded once, to the nearest binary64
  // The distance from touching as a length in the query's unit: rounded once, and what it certainly does not exceed.
  virtual double length() = 0;
  virtual double length_at_most() = 0;
  virtual bool is_touching() = 0;
  // The depth above which a wrong verdict counts as one on an engine-like query; infinity where the query is not one,
  // and in a predicate for which no query is.
  virtual double engine_threshold() { return std::numeric_limits<double>::infinity(); }

 protected:
  ~DepthOf() = default;
};

}  // namespace axiscert
