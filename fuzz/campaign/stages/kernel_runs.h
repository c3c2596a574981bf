// The kernels of a unit, all at one batch: asked, looked at, judged. Each step returns the type that the next one is a
// member of, so that the steps cannot be taken in another order, left out or repeated.
#pragma once

#include <deque>

#include "fuzz/campaign/stages/kernel_run.h"

namespace axiscert {

template <class Real>
class AnsweredBatch;
template <class Real>
class WatchedBatch;

// The kernels that exist in a precision.
template <class Real>
class KernelRuns {
 public:
  // The arguments have to outlive it; `tallies` and `standing` are by kernel of the plan, and `standing` may be empty.
  KernelRuns(const Plan& plan, const Source& source, Decider<Real>& decider, const std::vector<Standing>& standing,
             std::uint64_t first_position, std::vector<Tally>& tallies);
  KernelRuns(const KernelRuns&) = delete;

  bool empty() const { return runs_.empty(); }
  bool any_in_another_process() const;

  AnsweredBatch<Real> ask(const MadeBatch<Real>& batch);
  // After the last batch: counts what was put off.
  void finish();

 private:
  friend class AnsweredBatch<Real>;
  friend class WatchedBatch<Real>;

  void count_plain(const DecidedBatch<Real>& batch);
  void judge(const DecidedBatch<Real>& batch);
  void sample_critical_radii(const DecidedBatch<Real>& batch);
  void measure_margins(const DecidedBatch<Real>& batch);

  const Plan& plan_;
  Decider<Real>& decider_;
  std::deque<KernelRun<Real>> runs_;
  std::vector<char> open_;  // by query of the batch: some kernel's answer is not counted yet
};

// Every kernel has answered.
template <class Real>
class AnsweredBatch {
 public:
  // Looks at the errors of the computed sides.
  WatchedBatch<Real> look_at_errors(const DecidedBatch<Real>& batch) &&;

 private:
  friend class KernelRuns<Real>;
  explicit AnsweredBatch(KernelRuns<Real>& runs) : runs_(runs) {}
  KernelRuns<Real>& runs_;
};

// The errors of the sides are looked at, and no answer is judged.
template <class Real>
class WatchedBatch {
 public:
  // Counts the queries with nothing to see in bulk, judges the others one by one, and measures critical radii and
  // margins of the batch's share of the samples.
  void judge() &&;

 private:
  friend class AnsweredBatch<Real>;
  WatchedBatch(KernelRuns<Real>& runs, const DecidedBatch<Real>& batch) : runs_(runs), batch_(batch) {}
  KernelRuns<Real>& runs_;
  const DecidedBatch<Real>& batch_;
};

}  // namespace axiscert
