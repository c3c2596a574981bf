// The sixteen margins of a query of any finite numbers, enclosed: signs and errors that need neither a range nor exact
// arithmetic, where double the roundings of binary64 leave them certain.
#pragma once

#include <optional>

#include "exact/sphere_triangle/filters/signs.h"
#include "exact/numbers/wide_enclosed.h"
#include "kernel/query.h"

namespace axiscert {

// Whose sides an error is relative to. The signs are the same.
enum class EdgeSides : std::uint8_t { published, reduced };

// Of a valid query. Never allocates; the processor has to round to nearest, subnormals included.
class WideMargins {
 public:
  explicit WideMargins(const Query<double>& q);

  // All sixteen, where all are certain.
  std::optional<Signs> signs() const;

  // Certain bounds of the error of a comparison's computed sides, which are finite, in units of 2^-digits
  // (exact/sphere_triangle/measures/error_measure.h). Where the scale may be 0, `upper` is infinite and
  // `exponent_above` the greatest int; where no double is as great, `upper` alone.
  struct ErrorRange {
    double lower, upper;
    int exponent_above;  // the error is below 2^exponent_above
  };
  ErrorRange error(Comparison which, EdgeSides sides, double lhs, double rhs, int digits) const;

 private:
  struct Margin {
    WideEnclosed difference;  // lhs - rhs
    WideEnclosed lhs, rhs;    // not negative, but for the lhs of a side; of edge.side the rhs is 0
    int edge = -1;            // in the reduced form: published sides are its squared length times these
  };
  std::array<Margin, comparison_count> margins_;
  std::array<WideEnclosed, 3> edge_squares_;  // AB, BC, CA
};

}  // namespace axiscert
