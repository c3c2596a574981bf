// The cost of precision: the formulae of several kernels in several formats of numbers, with and without their limits
// on exponents, so that faults of rounding are distinguished from faults of range.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "exact/numbers/number_format.h"
#include "exact/sphere_triangle/unbounded.h"
#include "fuzz/campaign/progress.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/field.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {

// `unlimited` exponents are unbounded; `limited` ones are those of the format, with gradual underflow.
enum class ExponentRange : std::uint8_t { unlimited, limited };
template <>
inline constexpr std::size_t enum_count<ExponentRange> = 2;

struct PrecisionPlan {
  std::uint64_t seed = 1;
  std::uint64_t trials = 0;  // queries per source
  std::vector<const Kernel*> kernels;
  std::vector<SourcePtr> sources;
  Precision precision = Precision::binary32;  // of the queries
  std::vector<NumberFormat> numbers;          // by bits, ascending
  int threads = 0;                            // 0: one per core

  RoundingRule rounding = RoundingRule::nearest;
  // Each format is evaluated with the seeds 1 to so many, where rounding is by chance. What an operation draws follows
  // from the seed and the query's numbers.
  std::uint64_t rounding_seeds = 1;
  Contraction contraction = Contraction::none;
  // Whether the numbers of a query are rounded to the format, to nearest even, before anything is asked: the truth is
  // that of the rounded query.
  bool round_inputs = false;

  // Each format with each seed.
  std::size_t step_count() const { return numbers.size() * seeds(); }
  std::uint64_t seeds() const { return is_by_chance(rounding) ? rounding_seeds : 1; }
  const NumberFormat& number_of(std::size_t step) const { return numbers[step / seeds()]; }
  std::optional<std::uint64_t> seed_of(std::size_t step) const {
    return is_by_chance(rounding) ? std::optional(1 + step % seeds()) : std::nullopt;
  }
};

// The formats used if none is named: bits=P, more closely spaced near the published formats.
std::vector<NumberFormat> default_precision_numbers();

// Wrong verdicts, relative to the geometric truth.
struct VerdictFlips {
  std::uint64_t false_separation = 0, false_contact = 0;
  std::uint64_t total() const { return false_separation + false_contact; }
  bool operator==(const VerdictFlips&) const = default;

  static constexpr std::string_view about = "Wrong verdicts.";
  AXISCERT_FIELDS(VerdictFlips, AXISCERT_FIELD(false_separation, "Missed contacts."),
                  AXISCERT_FIELD(false_contact, "Phantom contacts."))
};

// One kernel's formulae at one number of bits, in one exponent range.
struct PrecisionCounts {
  VerdictFlips verdict;
  EnumArray<Comparison, std::uint64_t> comparisons{};
  bool operator==(const PrecisionCounts&) const = default;

  AXISCERT_FIELDS(PrecisionCounts, AXISCERT_FIELD(verdict, VerdictFlips::about),
                  AXISCERT_FIELD(comparisons, "Flips of each comparison against its own exact sign."))
};

struct PrecisionStep {
  std::uint64_t queries = 0;
  VerdictFlips exact;
  PrecisionCounts unlimited, limited;
  std::uint64_t rounding = 0, range = 0;
  PrecisionCounts& in(ExponentRange which) { return which == ExponentRange::unlimited ? unlimited : limited; }
  const PrecisionCounts& in(ExponentRange which) const { return const_cast<PrecisionStep*>(this)->in(which); }
  bool operator==(const PrecisionStep&) const = default;

  static constexpr std::string_view about = "In one format.";
  AXISCERT_FIELDS(PrecisionStep, AXISCERT_FIELD(queries, "Valid queries; of rounded ones, those that the format has."),
                  AXISCERT_FIELD(exact, "Wrong verdicts of the formulae in exact arithmetic on these."),
                  AXISCERT_FIELD(unlimited, "With exponents that have no limit."),
                  AXISCERT_FIELD(limited, "With the exponents of the format."),
                  AXISCERT_FIELD(rounding,
                                 "Verdicts that rounding changes: exact arithmetic's and, with unlimited exponents, "
                                 "that of these bits differ."),
                  AXISCERT_FIELD(range, "Verdicts that the limited exponents change."))
};

struct KernelPrecision {
  VerdictFlips exact;                // flips of the formulae in exact arithmetic: no number of bits removes these
  std::vector<PrecisionStep> steps;  // of the plan
  bool operator==(const KernelPrecision&) const = default;
  static constexpr auto fields(auto&& visit) { return merged(visit, &KernelPrecision::exact, &KernelPrecision::steps); }
};

// One source, or several together.
struct PrecisionTally {
  std::uint64_t queries = 0;             // valid queries only
  std::vector<KernelPrecision> kernels;  // in the plan's order
  bool operator==(const PrecisionTally&) const = default;
  static constexpr auto fields(auto&& visit) {
    return merged(visit, &PrecisionTally::queries, &PrecisionTally::kernels);
  }
};

// One tally per source. Depends on the plan alone, not on threads. Throws Error for a kernel whose formulae are not
// evaluated in plain arithmetic, or have no form with the contraction, OracleDisagreement, and HarnessFault if
// evaluation in the queries' own precision does not give the scalar reference's answer.
std::vector<PrecisionTally> measure_precision(const PrecisionPlan& plan, const ShowProgress& report = {});
PrecisionTally total(const std::vector<PrecisionTally>& tallies);

// The least bits of the plan's formats from which on, with unlimited exponents, each has queries, and none of these
// occurs; empty if the last has no query, or one occurs there:
//   verdict           a wrong verdict, against the geometric truth
//   own_verdict       a verdict other than that of the kernel's formulae in exact arithmetic
//   sufficient_bits   a flip of any of some comparisons
struct SufficientVerdictBits {
  std::optional<int> verdict, own_verdict;

  AXISCERT_FIELDS(
      SufficientVerdictBits,
      AXISCERT_FIELD(verdict,
                     "From so many bits on no verdict of these queries is wrong; null: none of those asked, or the "
                     "last was measured on nothing."),
      AXISCERT_FIELD(own_verdict, "The same against the formulae in exact arithmetic."))
};
SufficientVerdictBits sufficient_verdict_bits(const PrecisionPlan& plan, const KernelPrecision& kernel);
std::optional<int> sufficient_bits(const PrecisionPlan& plan, const KernelPrecision& kernel, ComparisonBits which);

}  // namespace axiscert
