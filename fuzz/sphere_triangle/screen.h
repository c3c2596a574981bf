// sphere-triangle's screen: filters decide nearly every query, and each kernel's answer to it is judged by the signs
// that they found; the oracles judge the rest, and a sample that checks the filters.
#pragma once

#include <cfenv>
#include <deque>
#include <optional>

#include "exact/sphere_triangle/asked_sphere_triangle.h"
#include "exact/sphere_triangle/oracles/cascade.h"
#include "fuzz/campaign/unit.h"
#include "fuzz/sphere_triangle/kernel_screen.h"

namespace axiscert {

// How the queries of a batch are decided: by filters, each of whose answers is certain, and by exact arithmetic where
// they are silent, on a sample of the rest, and on the close calls that they report.
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
  bool exact_only_;
  Filter<Real> filter_;
  Cascade<Real> cascade_;
  StepCounts& steps_;
  std::uint64_t& second_opinions_;
  std::vector<DecidedSigns> undecided_;  // where no filter is used
  std::vector<Screening> screening_;
};

// A query that the oracles are asked about: what a filter decided of it is compared with what they say.
template <class Real>
class CheckedQuery final : public AskedSphereTriangle<Real> {
 public:
  CheckedQuery(Decider<Real>& decider, const DecidedBatch<Real>& batch, std::size_t index)
      : AskedSphereTriangle<Real>(query_from(batch.queries[index]), decider.opinion_on(batch.position + index)),
        decider_(decider),
        batch_(batch),
        index_(index) {}
  std::size_t index() const { return index_; }  // in the batch

 private:
  void check_truth(const ExactTruth& truth) override { decider_.check(batch_, index_, this->query(), truth); }

  Decider<Real>& decider_;
  const DecidedBatch<Real>& batch_;
  std::size_t index_;
};

// The fault that is planted in the mode and not in the filter.
class StaleRounding {
 public:
  explicit StaleRounding(bool is_planted) : before_(std::fegetround()) {
    if (is_planted) std::fesetround(FE_UPWARD);
  }
  ~StaleRounding() { std::fesetround(before_); }

 private:
  int before_;
};

template <class Real>
class SphereTriangleScreen final : public Screen<Real> {
 public:
  explicit SphereTriangleScreen(const ScreenedRuns<Real>& of);

  void decide(const MadeBatch<Real>& batch) override;
  const std::vector<std::size_t>& count_in_bulk() override;
  void look_at_errors() override;
  bool try_judge(std::size_t k, std::size_t i) override;
  AskedQuery& about(std::size_t i) override { return look(i); }
  void look_at_answer(std::size_t k, std::size_t i, const typename KernelRun<Real>::JudgedAnswer& found) override;
  void sample() override;
  void finish() override;

 private:
  // The query at hand; the one before ends where another is asked for.
  CheckedQuery<Real>& look(std::size_t i);
  void sample_critical_radii();
  void measure_margins();

  const bool has_replies_, exact_only_;
  StaleRounding mode_;
  Decider<Real> decider_;
  std::deque<KernelScreen<Real>> kernels_;
  std::optional<DecidedBatch<Real>> batch_;
  std::vector<std::uint8_t> engine_like_;  // by query of the batch, where a kernel is judged by signs
  std::vector<std::size_t> open_;
  std::optional<CheckedQuery<Real>> look_;
};

const Screens& sphere_triangle_screens();

}  // namespace axiscert
