// A kernel at work on the batches of one unit.
#pragma once

#include "exact/judge/claim.h"
#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/measures/limits.h"
#include "exact/sphere_triangle/unbounded/reference_batch.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/error_watch.h"
#include "fuzz/campaign/repeated_judgements.h"
#include "kernel/ask.h"

namespace axiscert {

// The exact squared distance of one query and its depth, computed when first asked for: few queries need them.
template <class Real>
class LazyDistance final : public DepthOf {
 public:
  LazyDistance(const Query<Real>& q, bool exact_only) : query_(q), exact_only_(exact_only) {}
  const Rational& squared();
  std::optional<Real> within(const RadiusRange<Real>& range);  // correctly rounded; seldom needs the square
  double at_most() override;
  double exactly() override;
  void is_zero();  // the depth: of a query that touches

 private:
  const Query<Real>& query_;
  bool exact_only_;
  std::optional<Rational> squared_;
  std::optional<Real> rounded_;
  std::optional<double> at_most_, depth_;
};

// Somebody else's code is a process, begun with the unit: so what it does depends on the unit alone, and not on what
// the thread did before. What it borrows has to outlive it, and it does not move.
template <class Real>
class Runner {
 public:
  Runner(const Kernel& kernel, const Plan& plan, const Filter<Real>& filter, const Standing& known,
         std::uint64_t first_position, Tally& tally);
  Runner(const Runner&) = delete;

  // Whether the signs are all that judging it takes: the filters have them. Others are judged by exact sides.
  bool is_judged_by_signs() const { return by_signs_; }
  bool is_in_another_process() const { return implementation_.supervised != nullptr; }

  // What follows is about the batch whose first query is at `position`.
  void begin_batch(std::uint64_t position) { position_ = position; }
  void ask_about(const QueryBatch<Real>& batch);
  // Evaluates the reference and looks at the errors; of a kernel that is judged by signs.
  void look_at_sides(const QueryBatch<Real>& batch, const std::vector<Attention>& attention,
                     const std::vector<DecidedSigns>& decided);

  // Counts the queries of the batch on which no sign is a tie and nothing is wrong with the answer, but those that
  // exact arithmetic judges; and whether it did.
  void count_plain(const QueryColumns<Real>& batch, const std::vector<DecidedSigns>& decided,
                   const std::vector<char>& exactly);
  bool has_counted(std::size_t i) const { return !counted_.empty() && counted_[i]; }
  // Counts a query of the batch by its signs. The first only if nothing is wrong with the answer, and says whether.
  bool count_if_clean(std::size_t i, const Signs& signs, bool radius_is_zero, const Answer& answer);
  void judge_by_signs(std::size_t i, const Query<Real>& q, const Signs& signs, const Answer& answer,
                      LazyDistance<Real>& depth);
  // The same by the exact truth. Where a filter decided the query too, what it and the SIMD reference said is checked:
  // throws OracleDisagreement.
  void judge_exactly(std::size_t i, const Query<Real>& q, const Truth& truth, Claims<Real>* claims,
                     const Answer& answer, bool is_filtered, LazyDistance<Real>& depth);

  Answer answer(std::size_t i) const { return reply_.outcome(i); }
  // Of a query with a valid truth, whose sides `claims` evaluates.
  void measure_margins(const Query<Real>& q, Claims<Real>& claims, const Answer& answer);
  bool shows_comparisons() const { return kernel_.exposes != Exposure::verdict; }
  // Keeps a query for its critical radius; `distance` is asked where the answer and the limits allow one.
  void sample(const Query<Real>& q, std::size_t i, LazyDistance<Real>& distance);

  // After the last batch: what was put off.
  void finish();

 private:
  bool is_answered(std::size_t i) const { return reply_.verdicts[i] != Verdict::unanswered; }
  bool exposes_sides() const { return kernel_.exposes == Exposure::sides && reply_.has_bits; }

  const Kernel& kernel_;
  const Tolerances& tolerances_;
  const Standing& standing_;
  Tally& tally_;
  Implementation<Real> implementation_;
  RadiusRange<Real> radii_;
  bool by_signs_;
  std::uint64_t position_ = 0;  // of the batch's first query
  Reply<Real> reply_;
  ReferenceBatch<Real> reference_;
  ErrorWatch<Real> errors_;
  CleanCount clean_;
  std::vector<char> counted_;  // by query of the batch: by count_plain
  RepeatedJudgements repeated_;
  std::vector<Query<Real>> sampled_;
  std::vector<Real> distances_;  // exact, rounded, of the sampled queries
};

}  // namespace axiscert
