// Attribution of flipped comparisons to the query or to the formula, by the condition of the exact comparison.
#pragma once

#include <optional>
#include <vector>

#include "fuzz/campaign/progress.h"
#include "fuzz/instruments/extreme.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/field.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {

struct ConditionPlan {
  std::vector<const Kernel*> kernels;  // all of which expose comparisons
  std::vector<SourcePtr> sources;
  Precision precision = Precision::binary32;
  std::uint64_t trials = 0, seed = 1;  // trials: of each source
  std::uint64_t flip_limit = 0;        // flips evaluated per kernel, source and comparison: the first by position
  std::uint64_t sample = 0;  // queries per source, evenly spaced, whose comparisons that did not flip are evaluated too
  int threads = 0;           // 0: one per core
};

// One comparison of a kernel on one source. A flip is a difference between the kernel's bit and that of its own
// formulae in exact arithmetic. evaluated = ill_conditioned + unstable + undefined + not_decided.
struct ConditionCounts {
  std::uint64_t flips = 0, evaluated = 0, ill_conditioned = 0, ties = 0, unstable = 0, range = 0, undefined = 0,
                not_decided = 0;
  std::optional<MeasuredValue> least_unstable;  // kappa u, except for range: the clearest evidence against the formula
  std::uint64_t sampled = 0;
  std::optional<MeasuredValue> greatest_right;  // kappa u of those

  bool operator==(const ConditionCounts&) const = default;
  AXISCERT_FIELDS(ConditionCounts, AXISCERT_FIELD(flips, "Answers that differ from the exact sign."),
                  AXISCERT_FIELD(evaluated, "Flips that were examined."),
                  AXISCERT_FIELD(ill_conditioned,
                                 "Flips that the rounding of the query alone may cause: kappa u is at least 1."),
                  AXISCERT_FIELD(ties, "Of these, exact ties."),
                  AXISCERT_FIELD(unstable, "Flips caused by the formula: kappa u is below 1."),
                  AXISCERT_FIELD(range, "Of these, right if exponents were unlimited."),
                  AXISCERT_FIELD(undefined, "Flips where the exact comparison is 0/0."),
                  AXISCERT_FIELD(not_decided, "Flips where the margin has no derivative."),
                  journalled(&Of::least_unstable, LeastMeasured()),
                  AXISCERT_FIELD(sampled, "Right answers that were examined: those with an exact margin other than 0."),
                  journalled(&Of::greatest_right, GreatestMeasured()))
};

// How far the centre has to move for the answer to be right, relative to the scene:
// exact/sphere_triangle/measures/depth.h.
struct WrongVerdict {
  double depth;
  std::uint64_t position;
  bool operator==(const WrongVerdict&) const = default;
};

// One kernel on one source.
struct ConditionCell {
  EnumArray<Comparison, ConditionCounts> comparisons;
  // Wrong verdicts relative to the geometry.
  std::uint64_t false_separation = 0, false_contact = 0;
  std::vector<double> depths;           // depths of the wrong verdicts; sorted
  std::optional<WrongVerdict> deepest;  // the first of the deepest

  ConditionCounts total() const;
  bool operator==(const ConditionCell&) const = default;
};

struct ConditionResult {
  std::vector<std::uint64_t> valid, invalid;        // queries by source; those that are invalid are left out
  std::vector<std::vector<ConditionCell>> cells;    // by kernel, by source
  std::vector<std::vector<Decimal6>> flip_kappa_u;  // by kernel: kappa u of each evaluated flip if it is finite; sorted
  bool operator==(const ConditionResult&) const = default;
};

// Measures the scalar form of each kernel; the result depends on the plan alone, not on its threads. Throws
// OracleDisagreement.
ConditionResult measure_condition(const ConditionPlan& plan, const ShowProgress& report = {});

}  // namespace axiscert
