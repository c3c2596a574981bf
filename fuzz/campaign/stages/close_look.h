// One query of a batch, looked at closely: its numbers, its distance and its exact truth, each found when it is first
// asked for and shared by all kernels.
#pragma once

#include <optional>

#include "exact/sphere_triangle/claims/claim.h"
#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "fuzz/campaign/stages/decider.h"
#include "fuzz/campaign/counts/tally.h"

namespace axiscert {

// The exact squared distance of one query and its depth, computed when first asked for: few queries need them.
template <class Real>
class LazyDistance final : public DepthOf {
 public:
  LazyDistance(const Query<Real>& q, bool exact_only) : query_(q), exact_only_(exact_only) {}
  const Rational& squared();
  std::optional<Real> within(const RadiusRange<Real>& range);  // correctly rounded; seldom needs the square
  double at_least() override;
  double at_most() override;
  double exactly() override;
  double engine_threshold() override;
  bool is_touching() override { return is_touching_; }
  void set_touching();

 private:
  const DepthRange& range();

  const Query<Real>& query_;
  bool exact_only_, is_touching_ = false;
  std::optional<Rational> squared_;
  std::optional<Real> rounded_;
  std::optional<DepthRange> range_;
  std::optional<double> depth_;
};

template <class Real>
class CloseLook {
 public:
  CloseLook(Decider<Real>& decider, const DecidedBatch<Real>& batch, std::size_t index)
      : decider_(decider),
        batch_(batch),
        index_(index),
        query_(batch.queries[index]),
        distance_(query_, decider.is_exact_only()) {}
  CloseLook(const CloseLook&) = delete;

  std::size_t index() const { return index_; }  // in the batch
  const Query<Real>& query() const { return query_; }
  LazyDistance<Real>& distance() { return distance_; }
  const ExactTruth& truth();
  Claims<Real>* claims();  // null where the truth is `invalid`

 private:
  Decider<Real>& decider_;
  const DecidedBatch<Real>& batch_;
  std::size_t index_;
  Query<Real> query_;
  LazyDistance<Real> distance_;
  std::optional<ExactTruth> truth_;
  std::optional<Claims<Real>> claims_;
};

// The close look at the query at hand; the one before ends where another query is asked for.
template <class Real>
class CloseLooks {
 public:
  CloseLooks(Decider<Real>& decider, const DecidedBatch<Real>& batch) : decider_(decider), batch_(batch) {}
  CloseLook<Real>& at(std::size_t index) {
    if (!look_ || look_->index() != index) look_.emplace(decider_, batch_, index);
    return *look_;
  }

 private:
  Decider<Real>& decider_;
  const DecidedBatch<Real>& batch_;
  std::optional<CloseLook<Real>> look_;
};

}  // namespace axiscert
