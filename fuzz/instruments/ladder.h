// What each step of the article's derivation costs: accuracy, range and speed of its forms on the same queries.
#pragma once

#include "fuzz/instruments/error_spread.h"
#include "fuzz/instruments/exponent_window.h"
#include "fuzz/instruments/kernel_speed.h"
#include "fuzz/queries/source.h"
#include "kernel/kernel.h"

namespace axiscert {

struct LadderPlan {
  std::vector<const Kernel*> kernels;  // each shows its comparisons and exists in the precision
  std::vector<SourcePtr> sources;
  Precision precision = Precision::binary32;
  std::uint64_t trials = 0, seed = 1;  // trials of each source
  bool speed = true;
  int threads = 0;  // 0: one a core
};

// One comparison, or several together, against the kernel's own formulae in exact arithmetic.
struct ComparisonAccuracy {
  std::uint64_t false_separation = 0, missed_separation = 0;
  // Of those, the ones that the same operations get right with an unbounded exponent.
  std::uint64_t by_range = 0;
  // A computed side that is not finite; an error over |l| + |r| = 0. Neither is among the errors.
  std::uint64_t range_events = 0, without_scale = 0;
  ErrorSpread errors;  // none where the kernel does not show its sides

  std::uint64_t sign_errors() const { return false_separation + missed_separation; }
  std::uint64_t rounding_sign_errors() const { return sign_errors() - by_range; }
  void merge(const ComparisonAccuracy& other);
  bool operator==(const ComparisonAccuracy&) const = default;
};

// One kernel on the queries of one source, or of several.
struct KernelAccuracy {
  std::uint64_t queries = 0;  // whose truth is not `invalid`
  // Wrong verdicts against the geometric truth; a touching query is a contact, its flips are among both.
  std::uint64_t false_separation = 0, false_contact = 0, touching_flips = 0;
  std::array<ComparisonAccuracy, comparison_count> comparisons;
  std::vector<double> radius_errors_ulps;  // of critical radii (has_critical_radius); ascending in a result
  std::uint64_t radius_unbounded = 0;      // contact for no finite radius

  std::uint64_t verdict_flips() const { return false_separation + false_contact; }
  double flips_per_million() const {
    return queries == 0 ? 0 : 1e6 * static_cast<double>(verdict_flips()) / static_cast<double>(queries);
  }
  // Several comparisons together.
  ComparisonAccuracy of(ComparisonBits which) const;
  void merge(const KernelAccuracy& other);
  bool operator==(const KernelAccuracy&) const = default;
};

struct LadderEntry {
  const Kernel* kernel;
  KernelAccuracy all;                     // over the sources together
  std::vector<KernelAccuracy> by_source;  // in the plan's order
  AxisWindows windows;
  std::optional<KernelSpeed> speed;
};

// By kernel, in the plan's order. All but `speed` depends on the plan alone, not on its threads.
// Throws OracleDisagreement.
std::vector<LadderEntry> measure_ladder(const LadderPlan& plan);

}  // namespace axiscert
