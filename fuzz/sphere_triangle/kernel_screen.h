// One kernel's answers to the batches of one unit, judged by the signs that the filters found.
#pragma once

#include "exact/sphere_triangle/claims/asked_sphere_triangle.h"
#include "exact/sphere_triangle/unbounded/reference_batch.h"
#include "fuzz/campaign/stages/kernel_run.h"
#include "fuzz/sphere_triangle/clean_count.h"
#include "fuzz/sphere_triangle/error_watch.h"
#include "fuzz/sphere_triangle/repeated_judgements.h"

namespace axiscert {

// The arguments of the constructor have to outlive the object, which does not move.
template <class Real>
class KernelScreen {
 public:
  KernelScreen(KernelRun<Real>& run, const JudgingOptions& judging, const Filter<Real>& filter,
               std::uint64_t first_position);
  KernelScreen(const KernelScreen&) = delete;

  bool shows_comparisons() const { return kernel_.exposes != Exposure::verdict; }
  bool judges_by_signs() const { return by_signs_; }

  // Evaluates the reference and looks at the errors of the computed sides, where the kernel is judged by signs.
  void look_at_errors(const DecidedBatch<Real>& batch);
  // Counts the queries on which no sign is a tie and nothing is wrong with the answer, unless exact arithmetic judges
  // them.
  void count_clear(const DecidedBatch<Real>& batch);
  // Counts the engine-like queries of a batch, unless the kernel has limits: then they are counted one by one.
  void count_engine_like(std::uint64_t queries);
  bool has_counted(std::size_t i) const { return !counted_.empty() && counted_[i]; }

  // Counts a query by its signs if nothing is wrong with the answer, and returns whether it did.
  bool count_if_clean(std::size_t i, const Signs& signs, bool radius_is_zero);
  void judge_by_signs(std::size_t i, const Signs& signs, AskedSphereTriangle<Real>& look);
  // The oracles judged the answer to query `i`, which lies within the limits: counts the class of a wrong verdict's
  // input and the errors of the sides. Where a filter decided the query too, what it and the SIMD reference said is
  // checked: throws OracleDisagreement.
  void look_at_judged(std::size_t i, const typename KernelRun<Real>::JudgedAnswer& found, bool is_filtered,
                      AskedSphereTriangle<Real>& look);

  // The margins of a query with a valid truth, whose exact sides `asked` evaluates.
  void measure_margins(std::size_t i, AskedSphereTriangle<Real>& asked);
  // Keeps a query for its critical radius, where the answer and the limits allow one.
  void sample(const Query<Real>& q, std::size_t i, LazyDistance<Real>& distance);

  // After the last batch: counts what was put off.
  void finish();

 private:
  // Counts the class of the input of a wrong verdict.
  void count_wrong_input(std::size_t i, const Judgement& judgement, bool is_touching, AskedSphereTriangle<Real>& look);
  // Counts the errors of the computed sides of a query with a valid truth; `is_checked`: compares them and the SIMD
  // reference with what the filters said.
  void check_sides(std::size_t i, const ExactSides& exact, const std::optional<Reference>& chain, bool is_checked,
                   const Query<Real>& q);

  KernelRun<Real>& run_;
  const Kernel& kernel_;
  const Formulae formulae_;
  const Tolerances& tolerances_;
  Tally& tally_;
  RadiusRange<Real> radii_;
  bool has_classes_, exact_only_;
  bool by_signs_;  // the signs are all that judging it takes: the filters have them
  ReferenceBatch<Real> reference_;
  ErrorWatch<Real> errors_;
  CleanCount clean_;
  std::vector<char> counted_;  // by query of the batch: by count_clear
  RepeatedJudgements repeated_;
  std::vector<Query<Real>> sampled_;
  std::vector<Real> distances_;  // exact, rounded, of the sampled queries
};

}  // namespace axiscert
