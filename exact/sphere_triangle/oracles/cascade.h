// The steps that decide the signs of a query, cheapest first; each step either is certain or passes the query on.
// lanes     SIMD in doubles, or pairs of them. Silent: a margin within its bound; binary64: a difference or radius
//           outside 2^-100 to 2^100
// grid      integers of a few words (grid_signs.h): ties and triangles without area too. Silent: numbers whose exponent
//           differs too much, but for a radius far below the rest
// wide      doubles with a bound and an exponent of their own (wide_margins.h). Silent: a margin within its bound
// integers  as grid, in as many words as necessary (limb_integer.h). Never silent
// exact     BinaryNumber for the signs, CGAL for the verdict: --exact-only, the checks, and queries that are not valid.
//           Never silent
#pragma once

#include "exact/judge/batch_oracle.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/oracles/lane_filter.h"

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

// The sample that detects faults of the filters: their decisions compared with exact arithmetic.

// One in this many of the queries that integers of any size decide is decided by CGAL as well: these queries are few,
// and the hardest.
inline constexpr std::uint64_t integer_check_stride = 64;

// `truth` is that of a valid query. Throws OracleDisagreement if the signs, or the conclusions drawn from them, differ.
template <class Real>
void require_same(const DecidedSigns& decided, const ExactTruth& truth, const Query<Real>& q);

}  // namespace axiscert
