// How deep a wrong verdict on one query is.
#pragma once

#include <limits>

namespace axiscert {

// The distance of a query from touching, relative to its scene: of sphere-triangle |d - r| / max(|A-P|, |B-P|, |C-P|,
// r). Exact, and so only computed where it could be kept.
class DepthOf {
 public:
  virtual double at_least() = 0;  // both certainly, of exactly() too
  virtual double at_most() = 0;
  virtual double exactly() = 0;  // rounded once, to the nearest binary64
  virtual bool is_touching() = 0;
  // The depth above which a wrong verdict counts as one on an engine-like query; infinity where the query is not one,
  // and in a predicate for which no query is.
  virtual double engine_threshold() { return std::numeric_limits<double>::infinity(); }

 protected:
  ~DepthOf() = default;
};

}  // namespace axiscert
