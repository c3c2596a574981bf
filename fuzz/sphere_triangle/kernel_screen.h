// One kernel's answers to the batches of one unit, judged by the signs that the filters found.
#pragma once

#include <array>
#include <vector>

#include "exact/sphere_triangle/asked_sphere_triangle.h"
#include "exact/sphere_triangle/oracles/signs.h"
#include "exact/sphere_triangle/reference_batch.h"
#include "fuzz/campaign/unit.h"
#include "fuzz/record/tally.h"
#include "fuzz/sphere_triangle/error_watch.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// Queries on which a kernel's verdict, axes and comparisons are all as in exact arithmetic, and its verdict right.

class CleanCount {
 public:
  // `axes` are the separating ones; `has_bits`: the answer has comparisons.
  void add(AxisBits axes, ComparisonBits ties, bool touching, bool has_bits) {
    ++by_axes_[axes];
    with_bits_ += has_bits;
    touching_ += touching;
    if (ties != 0) add_ties(ties);
  }
  // The same for a kernel that claims no formulae.
  void add_verdict(Verdict verdict, bool touching) {
    ++(verdict == Verdict::separated ? separated_ : contact_);
    touching_ += touching;
  }
  void add_to(Tally& tally) const;

 private:
  void add_ties(ComparisonBits ties);
  std::array<std::uint64_t, std::size_t{1} << axis_count> by_axes_{};
  std::array<std::uint64_t, comparison_count> ties_{};
  std::uint64_t separated_ = 0, contact_ = 0, touching_ = 0, with_bits_ = 0;
};

// Judgements that repeat. Where queries leave the range nearly all have flips, but all that judging looks at is a few
// words of bits, and a family has few different ones: each is judged once, and then counted.

// All that the judgement of a query depends on, for one kernel whose answer has the bits of its reference or none: so
// queries with one pattern have one judgement.
struct JudgementPattern {
  Signs signs;
  ComparisonBits range_free, reference;
  Verdict answered;
  bool has_bits, radius_is_zero;
  bool operator==(const JudgementPattern&) const = default;
};

// A judgement, and how many queries had it after the first. Only the first is a witness: the later ones have the same
// flips at later positions.
struct RepeatedJudgement {
  JudgementPattern pattern{};
  Verdict truth{};
  bool is_touching = false;
  Answer answer{};
  Judgement judgement{};
  bool is_known = false;
  std::uint64_t repetitions = 0;

  std::optional<Flip> verdict_flip() const {
    if (!judgement.verdict_flip) return std::nullopt;
    return Flip{Level::verdict, 0, *judgement.verdict_flip, true, judgement.verdict_links};
  }
};

// A table of a fixed size: a pattern that finds no place is judged each time.
class RepeatedJudgements {
 public:
  // The entry of the pattern, or a free one for it; null where there is neither.
  RepeatedJudgement* find(const JudgementPattern& pattern);
  void add_to(Tally& tally) const;

 private:
  static constexpr std::size_t size = 2048, probes = 4;
  std::vector<RepeatedJudgement> table_;  // empty until first asked
};

// The arguments of the constructor have to outlive the object, which does not move.
template <class Real>
class KernelScreen {
 public:
  KernelScreen(KernelRun<Real>& run, const JudgingOptions& judging, const Filter<Real>& filter,
               std::uint64_t first_position);
  KernelScreen(const KernelScreen&) = delete;

  bool shows_comparisons() const { return kernel_.exposes != Exposure::verdict; }
  bool judges_by_signs() const { return by_signs_; }

  // These, where the kernel is judged by signs. Evaluates the reference, and counts the queries on which nothing is
  // wrong with the answer, unless exact arithmetic judges them. `engine_like` is of find_engine_like().
  void count_in_bulk(const DecidedBatch<Real>& batch, const std::vector<std::uint8_t>& engine_like);
  // Looks at the errors of the computed sides.
  void look_at_errors(const DecidedBatch<Real>& batch);
  bool has_counted(std::size_t i) const { return !counted_.empty() && counted_[i]; }

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
  std::vector<char> counted_;  // by query of the batch: by count_in_bulk
  RepeatedJudgements repeated_;
  std::vector<Query<Real>> sampled_;
  std::vector<Real> distances_;  // exact, rounded, of the sampled queries
};

}  // namespace axiscert
