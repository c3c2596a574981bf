// The cost of each step of the article's derivation: accuracy, range and speed of its forms on the same queries.
#pragma once

#include "fuzz/campaign/progress.h"
#include "fuzz/fields/field.h"
#include "fuzz/sphere_triangle/formulae/error_spread.h"
#include "fuzz/sphere_triangle/formulae/axis_windows.h"
#include "fuzz/sphere_triangle/formulae/kernel_speed.h"
#include "fuzz/queries/source.h"
#include "kernel/kernel.h"

namespace axiscert {

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
  // Computed sides that are not finite; errors over |l| + |r| = 0. Neither is among the errors.
  std::uint64_t range_events = 0, without_scale = 0;
  ErrorSpread errors;  // empty if the kernel does not expose its sides

  std::uint64_t sign_errors() const { return false_separation + missed_separation; }
  std::uint64_t rounding_sign_errors() const { return sign_errors() - by_range; }
  bool operator==(const ComparisonAccuracy&) const = default;
  static constexpr auto fields(auto&& visit) {
    using Of = ComparisonAccuracy;
    return visit(field(&Of::false_separation,
                       {"false_separation", "How often the kernel wrongly says yes; of the verdict a missed contact."}),
                 field(&Of::missed_separation, {"missed_separation", "How often the kernel wrongly says no."}),
                 field(&Of::by_range, {"by_range", "How many of both are right once exponents are unlimited."}),
                 journalled(&Of::range_events), journalled(&Of::without_scale), journalled(&Of::errors));
  }
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
  KernelAccuracy all;                     // over the sources together
  std::vector<KernelAccuracy> by_source;  // in the plan's order
  AxisWindows windows;
  std::optional<KernelSpeed> speed;
};

// One entry per kernel, in the plan's order. Everything but `speed` depends on the plan alone, not on its threads.
// Throws OracleDisagreement.
std::vector<LadderEntry> measure_ladder(const LadderPlan& plan, const ShowProgress& report = {});

}  // namespace axiscert
