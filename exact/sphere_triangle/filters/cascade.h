// The steps that decide the signs of a query, cheapest first; each step either is certain or passes the query on.
#pragma once

#include "exact/sphere_triangle/filters/lane_filter.h"
#include "exact/trait/steps.h"

namespace axiscert {

struct DecidedSigns {
  Signs signs;  // not set if the step is `exact`
  Step step = Step::exact;
  bool is_close = false;  // a close call in the lanes, to be examined again
  SignBits certain_in_lanes = 0;
};

// Allocates nothing if it is kept from one batch to the next.
template <class Real>
class Cascade {
 public:
  explicit Cascade(const Filter<Real>& filter) : filter_(filter) {}

  // The signs of each query of the batch.
  const std::vector<DecidedSigns>& decide(const QueryBatch<Real>& batch);
  // Time spent so far, in nanoseconds.
  double nanoseconds(Step step) const { return nanoseconds_[step]; }

 private:
  // Calls signs_of for each valid query that no step has decided yet.
  template <class SignsOf>
  void try_left(const QueryBatch<Real>& batch, Step step, SignsOf&& signs_of);

  Filter<Real> filter_;
  std::vector<FilteredSigns> filtered_;
  std::vector<DecidedSigns> decided_;
  EnumArray<Step, double> nanoseconds_{};
};

}  // namespace axiscert
