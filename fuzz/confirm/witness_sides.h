// The two sides of a witness's comparisons: exact, computed, and their difference.
#pragma once

#include "exact/trait/examine.h"
#include "fuzz/record/witness_record.h"

namespace axiscert {

class WitnessSides {
 public:
  // For each comparison: the exact lhs, rhs and margin to 17 significant digits, the computed sides as hex-floats, the
  // error of each side in ulps of the exact one and that of their difference in u (rounded up). Includes every
  // comparison of an axis with a flip and those in `largest_errors`; all if a verdict is wrong without a flip. Empty
  // for a kernel that claims no formulae with comparisons, and for a query without a truth.
  virtual std::optional<NamedValues<SidesRecord>> of(const Numbers<float>& q, const Kernel& kernel,
                                                     const Examination& found, ComparisonBits largest_errors) const = 0;
  virtual std::optional<NamedValues<SidesRecord>> of(const Numbers<double>& q, const Kernel& kernel,
                                                     const Examination& found, ComparisonBits largest_errors) const = 0;

 protected:
  ~WitnessSides() = default;
};

}  // namespace axiscert
