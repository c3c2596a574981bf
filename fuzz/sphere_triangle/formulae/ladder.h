// The cost of each step of the article's derivation: accuracy, range and speed of its forms on the same queries.
#pragma once

#include <bit>
#include <map>
#include <optional>
#include <string_view>

#include "exact/judge/side_error.h"
#include "fuzz/campaign/progress.h"
#include "fuzz/queries/source.h"
#include "fuzz/sphere_triangle/formulae/axis_windows.h"
#include "fuzz/sphere_triangle/formulae/contrasts.h"
#include "fuzz/sphere_triangle/formulae/kernel_speed.h"
#include "fuzz/text/field.h"
#include "kernel/kernel.h"

namespace axiscert {
// The errors of comparisons over many queries: their maximum, exact, and their quantiles.

// Errors of Kind::finite, in u. The result of merging does not depend on the order.
//
// A quantile is a lower order statistic of the estimates upper(), which lie within 2^-39 of the errors: those are
// counted in buckets [x, x (1 + 2^-10)] at most, and the result is the middle of the bucket that contains the
// statistic, within 2^-11 of it. So the memory does not grow with the number of queries.
class ErrorSpread {
 public:
  void add(const SideError& error) {
    double estimate = error.upper();
    if (estimate > 0 && estimate >= worst_.value()) {
      const Decimal6 exact = error.rounded_up();
      worst_ = std::max(worst_, exact);
      if (!std::isfinite(estimate)) estimate = exact.value();
    } else if (!std::isfinite(estimate)) {
      estimate = error.rounded_up().value();
    }
    ++buckets_[std::bit_cast<std::uint64_t>(estimate) >> dropped_bits];
    ++count_;
  }
  void merge(const ErrorSpread& other) {
    for (const auto& [bucket, count] : other.buckets_) buckets_[bucket] += count;
    count_ += other.count_;
    worst_ = std::max(worst_, other.worst_);
  }

  std::uint64_t count() const { return count_; }
  Decimal6 worst() const { return worst_; }  // rounded up
  // The lower order statistic at `percent`; empty without errors; infinite beyond binary64's range.
  std::optional<double> quantile(unsigned percent) const {
    if (count_ == 0) return std::nullopt;
    // (count - 1) percent / 100, rounded down, without leaving 64 bits.
    const std::uint64_t last = count_ - 1, rank = last / 100 * percent + last % 100 * percent / 100;
    std::uint64_t below = 0;
    for (const auto& [bucket, count] : buckets_) {
      below += count;
      if (below > rank) return middle(bucket);
    }
    return std::nullopt;
  }
  bool operator==(const ErrorSpread&) const = default;

 private:
  static constexpr unsigned dropped_bits = 52 - 10;  // dropped from a non-negative binary64 number
  static double middle(std::uint64_t bucket) {
    const double least = std::bit_cast<double>(bucket << dropped_bits);
    if (least == 0 || !std::isfinite(least)) return least;
    return std::bit_cast<double>((bucket << dropped_bits) | (std::uint64_t{1} << (dropped_bits - 1)));
  }

  std::map<std::uint64_t, std::uint64_t> buckets_;
  std::uint64_t count_ = 0;
  Decimal6 worst_;
};

struct LadderPlan {
  std::vector<const Kernel*> kernels;  // each exposes its comparisons and exists in the precision
  std::vector<SourcePtr> sources;
  Precision precision = Precision::binary32;
  std::uint64_t trials = 0, seed = 1;  // trials of each source
  bool speed = true;
  int threads = 0;  // 0: one per core
};

// One comparison, or several together, relative to the kernel's own formulae in exact arithmetic.
struct ComparisonAccuracy {
  std::uint64_t false_separation = 0, missed_separation = 0, by_range = 0;
  // Computed sides that are not finite; errors over |l| + |r| = 0, or of a right side that is a root. Neither is among
  // the errors.
  std::uint64_t range_events = 0, without_scale = 0;
  ErrorSpread errors;  // empty if the kernel does not expose its sides

  std::uint64_t sign_errors() const { return false_separation + missed_separation; }
  std::uint64_t rounding_sign_errors() const { return sign_errors() - by_range; }
  bool operator==(const ComparisonAccuracy&) const = default;
  AXISCERT_FIELDS(ComparisonAccuracy,
                  AXISCERT_FIELD(false_separation,
                                 "How often the kernel wrongly says yes; of the verdict a missed contact."),
                  AXISCERT_FIELD(missed_separation, "How often the kernel wrongly says no."),
                  AXISCERT_FIELD(by_range, "How many of both are right once exponents are unlimited."),
                  journalled(&Of::range_events), journalled(&Of::without_scale), journalled(&Of::errors))
};

// One kernel on the queries of one source, or of several.
struct KernelAccuracy {
  std::uint64_t queries = 0;  // queries whose truth is not `invalid`
  // Wrong verdicts relative to the geometric truth; a touching query is a contact, and its flips are included in both.
  std::uint64_t false_separation = 0, false_contact = 0, touching_flips = 0;
  std::array<ComparisonAccuracy, comparison_count> comparisons;
  std::vector<double> radius_errors_ulps;  // errors of critical radii (has_critical_radius); ascending in a result
  std::uint64_t radius_unbounded = 0;      // contact for no finite radius

  std::uint64_t verdict_flips() const { return false_separation + false_contact; }
  double flips_per_million() const {
    return queries == 0 ? 0 : 1e6 * static_cast<double>(verdict_flips()) / static_cast<double>(queries);
  }
  // Several comparisons together.
  ComparisonAccuracy of(ComparisonBits which) const;
  bool operator==(const KernelAccuracy&) const = default;
  static constexpr auto fields(auto&& visit) {
    using Of = KernelAccuracy;
    return merged(visit, &Of::queries, &Of::false_separation, &Of::false_contact, &Of::touching_flips, &Of::comparisons,
                  &Of::radius_errors_ulps, &Of::radius_unbounded);
  }
};

struct LadderEntry {
  const Kernel* kernel;
  KernelAccuracy all;                     // over the sources together: each weighs as much as it has valid queries
  std::vector<KernelAccuracy> by_source;  // in the plan's order
  AxisWindows windows;
  std::optional<KernelSpeed> speed;
};

struct LadderResult {
  std::vector<LadderEntry> entries;  // one per kernel, in the plan's order
  std::vector<Contrast> contrasts;
  std::vector<SourceContrasts> by_source;  // what the forms get wrong, by clusters; in the plan's order

  bool is_of_nothing() const;  // no query was valid
};

// Everything but `speed` depends on the plan alone, not on its threads. Throws OracleDisagreement.
LadderResult measure_ladder(const LadderPlan& plan, const ShowProgress& report = {});

// The interval in which all of the axes are sound.
std::optional<ExponentWindow> common_window(const AxisWindows& windows, AxisBits axes);

// The step that worsens a figure most, among the steps that worsen it at all.
struct CostliestSteps {
  std::optional<std::size_t> sign_errors;           // the greatest increase
  std::optional<std::size_t> rounding_sign_errors;  // the same, without sign errors by range
  std::optional<std::size_t> worst_error;           // the greatest factor
  std::optional<std::size_t> range;                 // the most octaves lost
};
// On the queries of one source, by its place in the plan.
CostliestSteps costliest_steps(const std::vector<LadderEntry>& entries, const std::vector<LadderStep>& steps,
                               AxisKind kind, std::size_t source);

// The positions of the entries for which no other entry is both faster and wrong less often, over the sources together;
// the fastest first. All entries must have `speed`.
std::vector<std::size_t> accuracy_speed_front(const std::vector<LadderEntry>& entries);

}  // namespace axiscert
