// The sixteen margins of a query of any finite numbers, enclosed: they give signs and errors without any limit on the
// range and without exact arithmetic, whenever binary64 rounding leaves them certain.
#pragma once

#include <optional>

#include "exact/sphere_triangle/oracles/signs.h"
#include "exact/numbers/wide_enclosed.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// The form whose sides an error is relative to. The signs are the same in both.
enum class EdgeSides : std::uint8_t { published, reduced };

// The margins of a valid query. Never allocates; the processor has to round to nearest, with subnormals enabled.
class WideMargins {
 public:
  explicit WideMargins(const Query<double>& q);

  // All sixteen signs if all are certain; else empty.
  std::optional<Signs> signs() const;

  // Certain bounds of the error of a comparison's computed sides, which are finite, in units of 2^-digits
  // (exact/judge/side_error.h). If the scale may be 0, `upper` is infinite and `exponent_above`
  // the greatest int; if no double is great enough, only `upper` is infinite.
  struct ErrorRange {
    double lower, upper;
    int exponent_above;  // the error is below 2^exponent_above
  };
  ErrorRange error(Comparison which, EdgeSides sides, double lhs, double rhs, int digits) const;

 private:
  struct Margin {
    WideEnclosed difference;  // lhs - rhs
    WideEnclosed lhs, rhs;    // not negative, except the lhs of a side; the rhs of edge.side is 0
    int edge = -1;            // in the reduced form: published sides are these times the squared length of this edge
  };
  EnumArray<Comparison, Margin> margins_;
  std::array<WideEnclosed, 3> edge_squares_;  // AB, BC, CA
};

}  // namespace axiscert
