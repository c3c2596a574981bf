// A batch of which the filters have decided what they can.
#pragma once

#include <vector>

#include "exact/sphere_triangle/filters/cascade.h"
#include "fuzz/campaign/stages/kernel_run.h"

namespace axiscert {

// How an error watch looks at a query.
enum class Screening : std::uint8_t {
  skipped,        // not looked at: no truth, or counted elsewhere
  screened,       // by the watch
  cross_checked,  // counted elsewhere, exactly; what the filter says of it is kept for the cross-check
};

// For each query how it is judged: by signs that a filter decided, or by exact arithmetic.
template <class Real>
struct DecidedBatch : MadeBatch<Real> {
  const std::vector<DecidedSigns>& signs;
  const std::vector<Screening>& screening;  // of the error watches

  // A filter decided query `i`, whether or not exact arithmetic judges it again.
  bool is_filtered(std::size_t i) const { return signs[i].step != Step::exact; }
  bool is_exact(std::size_t i) const { return screening[i] != Screening::screened; }
};

}  // namespace axiscert
