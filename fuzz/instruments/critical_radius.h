// The critical radii of kernels over families: their distance from the exact one, its direction, and whether the
// answers are monotone.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fuzz/campaign/progress.h"
#include "fuzz/instruments/extreme.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/field.h"
#include "kernel/kernel.h"

namespace axiscert {

// Kernels and sources are of one predicate, whose answer turns at a critical length (exact/judge/oracles.h).
struct CriticalRadiusPlan {
  std::vector<const Kernel*> kernels;
  std::vector<SourcePtr> sources;
  Precision precision = Precision::binary32;
  std::uint64_t trials = 0, seed = 1;  // trials: of each source
  int threads = 0;                     // 0: one per core
};

// What `axiscert critical-radius` measures of a predicate where nothing is named. A predicate that has none of these:
// all of its kernels and families.
struct CriticalRadiusDefaults {
  std::vector<std::string> kernels, families;
};

// The first reversal of a kernel on a source: two lines of a query file that differ only in r.
struct ReversalWitness {
  std::uint64_t position;
  std::string contact, separated;  // in order of r
  bool operator==(const ReversalWitness&) const = default;
};

// One kernel on one source. Errors are in ulps of the exact distance and relative to the exact critical radius, which
// is the least float not below that distance; measured = right + early + late + unbounded.
struct CriticalRadii {
  std::uint64_t measured = 0;
  std::uint64_t right = 0;                   // the exact critical radius
  std::uint64_t early = 0;                   // contact for a radius below the distance: a phantom
  std::uint64_t late = 0;                    // separated for a radius not below it: missed
  std::uint64_t unbounded = 0;               // separated at the greatest finite radius
  std::uint64_t unanswered = 0;              // not measured: the kernel did not answer at some radius
  std::uint64_t undecided = 0, invalid = 0;  // not measured: it said that at some radius, which may be the change found
  std::uint64_t outside_limits = 0;          // not measured: beyond the kernel's limits at the exact critical radius
  std::uint64_t reversals = 0;               // queries on which the answers are not monotone
  std::map<Decimal6, std::uint64_t> errors;  // all but the unbounded ones, with their counts
  std::optional<MeasuredValue> worst_early, worst_late;
  std::optional<ReversalWitness> first_reversal;

  // The least error that `share` of the measured ones do not exceed; empty if that is an unbounded one, or none was
  // measured.
  std::optional<Decimal6> quantile(double share) const;
  std::uint64_t within(const Decimal6& error) const;
  bool operator==(const CriticalRadii&) const = default;
  // Merged in the order of positions.
  static constexpr auto fields(auto&& visit) {
    using Of = CriticalRadii;
    return merged(visit, &Of::measured, &Of::right, &Of::early, &Of::late, &Of::unbounded, &Of::unanswered,
                  &Of::undecided, &Of::invalid, &Of::outside_limits, &Of::reversals, &Of::errors,
                  journalled(&Of::worst_early, GreatestMeasured()), journalled(&Of::worst_late, GreatestMeasured()),
                  journalled(&Of::first_reversal, by::first));
  }
};

struct CriticalRadiusResult {
  std::vector<std::uint64_t> left_out;            // by source: invalid queries, and distances beyond the precision
  std::vector<std::vector<CriticalRadii>> cells;  // by kernel, by source
  bool operator==(const CriticalRadiusResult&) const = default;
  static constexpr auto fields(auto&& visit) {
    return merged(visit, journalled(&CriticalRadiusResult::left_out, by::added), &CriticalRadiusResult::cells);
  }
};

// Measures the scalar form of each kernel; the result depends on the plan alone, not on its threads.
CriticalRadiusResult measure_critical_radii(const CriticalRadiusPlan& plan, const ShowProgress& report = {});

}  // namespace axiscert
