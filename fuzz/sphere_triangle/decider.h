// How the queries of a batch are decided: by filters, each of whose answers is certain, and by exact arithmetic where
// they are silent, on a sample of the rest, and on the close calls that they report.
#pragma once

#include <vector>

#include "exact/sphere_triangle/filters/cascade.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/trait/oracles.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/stages.h"

namespace axiscert {
// A batch of which the filters have decided what they can.

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

template <class Real>
class Decider {
 public:
  Decider(const JudgingOptions& judging, const std::string& target, StepCounts& steps, std::uint64_t& second_opinions)
      : exact_only_(judging.exact_only),
        filter_(filter_on<Real>(target, judging.planted)),
        cascade_(filter_),
        steps_(steps),
        second_opinions_(second_opinions) {
    steps_.signs.resize(comparison_count);
  }

  const Filter<Real>& filter() const { return filter_; }
  // Good until the next call.
  DecidedBatch<Real> decide(const MadeBatch<Real>& made);

  // How the oracles are asked about the query at this position.
  Opinion opinion_on(std::uint64_t position) const;
  // Compares the exact truth of query `index`, which is `q`, with what a filter decided. Throws OracleDisagreement.
  void check(const DecidedBatch<Real>& batch, std::size_t index, const Query<Real>& q, const ExactTruth& truth);

  // Adds the time that the filters took, in nanoseconds, to the counts.
  void count_times() const;

 private:
  void count_step(const DecidedSigns& found);

  bool exact_only_;
  Filter<Real> filter_;
  Cascade<Real> cascade_;
  StepCounts& steps_;
  std::uint64_t& second_opinions_;
  std::vector<DecidedSigns> undecided_;  // where no filter is used
  std::vector<Screening> screening_;
};

}  // namespace axiscert
