// One kernel at work on the batches of one unit. KernelRuns calls it, in the order of the stages.
#pragma once

#include "exact/sphere_triangle/unbounded/reference_batch.h"
#include "fuzz/campaign/stages/close_look.h"
#include "fuzz/campaign/stages/error_watch.h"
#include "fuzz/campaign/stages/repeated_judgements.h"
#include "kernel/ask.h"

namespace axiscert {

// A plug-in is a process, begun with the unit: what it does depends on the unit alone, and not on what the thread did
// before. The arguments of the constructor have to outlive the object, which does not move.
template <class Real>
class KernelRun {
 public:
  KernelRun(const Kernel& kernel, const Plan& plan, const Source& source, const Filter<Real>& filter,
            const Standing& known, std::uint64_t first_position, Tally& tally);
  KernelRun(const KernelRun&) = delete;

  bool is_in_another_process() const { return implementation_.supervised != nullptr; }
  bool shows_comparisons() const { return kernel_.exposes != Exposure::verdict; }

  // Asks the kernel; where the plan has stored replies, they are its answers.
  void ask_about(const MadeBatch<Real>& batch);
  // Evaluates the reference and looks at the errors of the computed sides, where the kernel is judged by signs.
  void look_at_errors(const DecidedBatch<Real>& batch);
  // Counts the queries on which no sign is a tie and nothing is wrong with the answer, unless exact arithmetic judges
  // them.
  void count_plain(const DecidedBatch<Real>& batch);
  // Counts the engine-like queries of a batch, unless the kernel has limits: then judge() does.
  void count_engine_like(std::uint64_t queries);
  bool has_counted(std::size_t i) const { return !counted_.empty() && counted_[i]; }
  // Judges and counts a query that count_plain left.
  void judge(const DecidedBatch<Real>& batch, std::size_t i, bool radius_is_zero, CloseLooks<Real>& looks);

  // The margins of a query with a valid truth, whose exact sides `claims` evaluates.
  void measure_margins(const Query<Real>& q, std::size_t i, Claims<Real>& claims);
  // Keeps a query for its critical radius, where the answer and the limits allow one.
  void sample(const Query<Real>& q, std::size_t i, LazyDistance<Real>& distance);

  // After the last batch: counts what was put off.
  void finish();

 private:
  Answer answer(std::size_t i) const;
  bool is_answered(std::size_t i) const { return reply_.verdicts[i] != Verdict::unanswered; }
  bool exposes_sides() const { return kernel_.exposes == Exposure::sides && reply_.has_bits; }

  // Counts a query by its signs if nothing is wrong with the answer, and returns whether it did.
  bool count_if_clean(std::size_t i, const Signs& signs, bool radius_is_zero, const Answer& answer);
  void judge_by_signs(const Signs& signs, const Answer& answer, CloseLook<Real>& look);
  // Judges by the exact truth. Where a filter decided the query too, what it and the SIMD reference said is checked:
  // throws OracleDisagreement.
  void judge_exactly(const Answer& answer, bool is_filtered, CloseLook<Real>& look);
  // Counts the class of the input of a wrong verdict.
  void count_wrong_input(CloseLook<Real>& look, const Judgement& judgement, bool is_touching);
  // Counts the errors of the computed sides of a query with a valid truth; `is_checked`: compares them and the SIMD
  // reference with what the filters said.
  void check_sides(const FormulaTruth& exact, const std::optional<Reference>& chain, bool is_checked,
                   const CloseLook<Real>& look);

  const Kernel& kernel_;
  const Source& source_;
  const StoredReplies* replies_;  // null: the kernel itself is asked
  const Tolerances& tolerances_;
  const Standing& standing_;
  Tally& tally_;
  Implementation<Real> implementation_;
  RadiusRange<Real> radii_;
  bool has_classes_, exact_only_;
  bool by_signs_;               // the signs are all that judging it takes: the filters have them
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
