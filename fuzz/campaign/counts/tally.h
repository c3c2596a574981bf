// The counts of a run, per kernel, precision and source. Tallies of units merge in any order to the same result.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/numbers/decimal6.h"
#include "exact/judge/judge.h"
#include "fuzz/campaign/counts/depths.h"
#include "fuzz/campaign/counts/class_tally.h"
#include "fuzz/campaign/counts/leaders.h"
#include "fuzz/campaign/counts/margins.h"
#include "fuzz/campaign/counts/motion_tally.h"
#include "kernel/finding.h"

namespace axiscert {

struct ExactSides;
class SideError;
template <class Real>
struct Answers;

using LinkCounts = EnumArray<Link, std::uint64_t>;

// Sign errors of one axis or one comparison against the kernel's own formulae in exact arithmetic.
struct SignTally {
  std::uint64_t false_separation = 0, missed_separation = 0, masked = 0, decisive = 0;
  std::uint64_t tolerance_failures = 0;
  LinkCounts links{};
};

struct AxisTally : SignTally {
  std::uint64_t sole_separator = 0;  // in exact arithmetic
};

struct ComparisonTally : SignTally {
  std::uint64_t ties = 0, range_events = 0, error_without_scale = 0;
  Leaders<Decimal6> largest_error;              // in u, other than zero
  Leaders<bool> false_witness, missed_witness;  // ranked by whether the flip is decisive
};

// Counts of valid queries outside the limits that a kernel declares; only the truth counts them too.
struct OutsideTally {
  std::uint64_t trials = 0, false_separation = 0, false_contact = 0, unanswered = 0;
  std::uint64_t contact = 0, touching = 0;  // the truth; touching is part of contact
  double deepest = 0;
};

struct VerdictTally {
  std::uint64_t false_separation = 0, false_contact = 0, undecided = 0, invalid = 0, unanswered = 0;
  std::uint64_t undecided_contact = 0, undecided_touching = 0;  // of undecided; touching is part of contact
  std::uint64_t touching_flips = 0;
  LinkCounts links{}, masked_links{}, touching_links{};                   // touching_links: those of touching_flips
  Leaders<double> deepest_false_separation{3}, deepest_false_contact{3};  // ranked by depth
  EnumArray<Link, Leaders<double>> deepest_by_link;                       // the deepest with that link broken
  // The first wrong verdict with that link broken; but for `implementation`, on a query that does not touch.
  EnumArray<Link, std::optional<std::uint64_t>> first_by_link;
  OutsideTally outside_limits;
  DepthTally depths;
  EngineTally engine;
};

struct CriticalRadiusTally {
  // Unsorted, of a source at most 2^16 (has_critical_radius); negative where the kernel says contact too early, at a
  // radius below the exact distance.
  std::vector<double> errors_ulps;
  std::uint64_t unbounded = 0;               // contact for no radius, finite and within the limits
  std::uint64_t unanswered = 0;              // not measured: a radius got no answer
  std::uint64_t undecided = 0, invalid = 0;  // not measured: that was the answer to some radius

  void merge(const CriticalRadiusTally& other);
};

// One kind of finding: how often, and the first of them.
struct FindingTally {
  std::uint64_t count = 0, first = 0;
  std::string detail;  // of the first
};

struct Tally {
  explicit Tally(const TestDescription& test) : axes(test.clauses.size()), comparisons(test.comparisons.size()) {}

  std::uint64_t trials = 0;
  std::uint64_t separated = 0, contact = 0, touching = 0, invalid = 0;  // the truth; touching is part of contact
  VerdictTally verdict;
  std::vector<AxisTally> axes;  // by clause
  std::vector<ComparisonTally> comparisons;
  CriticalRadiusTally critical_radius;
  EnumArray<FindingKind, FindingTally> findings;
  MarginTally margins;  // of the source's first queries (has_margins)
  ClassTally classes;   // of a kernel with has_input_classes()
  MotionTally motion;   // of a test with measures

  void merge(const Tally& other);
};

// The leaders that other units of the same cell have found: a query that is certainly no greater is not evaluated.
struct Standing {
  std::vector<Leaders<Decimal6>> largest_error;  // by comparison
  VerdictTally verdict;                          // its leaders

  bool could_keep_depth(const Flip& flip, const Candidate<double>& at_most) const;
};
Standing standing_of(const Tally& tally);

// Tolerated error by comparison, in u; none: not checked.
class Tolerances {
 public:
  const std::optional<Rational>& operator[](std::size_t comparison) const {
    static const std::optional<Rational> none;
    return comparison < given_.size() ? given_[comparison] : none;
  }
  void set(std::size_t comparison, const Rational& tolerated) {
    if (given_.size() <= comparison) given_.resize(comparison + 1);
    given_[comparison] = tolerated;
  }

 private:
  std::vector<std::optional<Rational>> given_;
};

// Counts everything of a query within the kernel's limits but the errors of the sides. `ties` are those of the kernel's
// own formulae in exact arithmetic, where they have comparisons; `depth` is asked where the verdict is wrong.
void count(Tally& tally, std::uint64_t position, const Truth& truth, ComparisonBits ties, const Answer& answer,
           const Judgement& judgement, DepthOf& depth, const Standing& standing);

// The part of count() that adds up: the same for each of `times` queries with this judgement.
void count_numbers(Tally& tally, const Truth& truth, ComparisonBits ties, const Answer& answer,
                   const Judgement& judgement, std::uint64_t times);
// The part of count() that counts and keeps the depth of a wrong verdict.
void count_depth(Tally& tally, std::uint64_t position, const Flip& flip, DepthOf& depth, const Standing& standing);

// Counts a valid query outside the kernel's limits.
void count_outside(Tally& tally, const Truth& truth, const Answer& answer, const Judgement& judgement, DepthOf& depth);

void count_finding(Tally& tally, FindingKind kind, std::uint64_t position, const std::string& detail);

// A smaller error than the largest so far may round up to the same decimal, at an earlier position.
inline double least_of_interest(const ComparisonTally& comparison) {
  return comparison.largest_error.best().value() * Decimal6::least_ratio;
}

// Counts the error of one comparison's sides. Returns whether it exceeds what is tolerated.
bool count_side_error(ComparisonTally& comparison, std::uint64_t position, const SideError& error,
                      const std::optional<Rational>& tolerated);

// Counts the errors of the sides of query `index` of a batch, whose answers are `computed`, against its exact sides.
template <class Real>
void count_errors(Tally& tally, std::uint64_t position, const TestDescription& test, const ExactSides& exact,
                  const Answers<Real>& computed, std::size_t index, const Tolerances& tolerances);

}  // namespace axiscert
