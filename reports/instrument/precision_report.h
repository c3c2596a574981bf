// The report of `axiscert precision`.
#pragma once

#include "fuzz/text/field.h"
#include "fuzz/sphere_triangle/formulae/precision.h"
#include "reports/instrument/data.h"
#include "reports/instrument/sweep_axis.h"
#include "reports/instrument/instrument.h"

namespace axiscert {
// precision.json: what `axiscert precision` writes.

struct IntegerBitsData {
  int per_bit = 0, constant = 0;

  AXISCERT_FIELDS(IntegerBitsData, AXISCERT_FIELD(per_bit, "Bits for each bit of the integers."),
                  AXISCERT_FIELD(constant, "And so many more."))
};

struct ComparisonBitsData {
  std::optional<double> degree_lhs, degree_rhs;
  std::optional<IntegerBitsData> integer_bits;
  std::optional<int> sufficient_bits;

  AXISCERT_FIELDS(
      ComparisonBitsData, AXISCERT_FIELD(degree_lhs, "The degree of the left side; null: it is zero."),
      AXISCERT_FIELD(degree_rhs, "The degree of the right side."),
      AXISCERT_FIELD(integer_bits,
                     "Enough to round nothing on integers of b bits; null for a form with roots or divisions."),
      AXISCERT_FIELD(sufficient_bits,
                     "From so many bits on it does not flip on these queries; null: none of those asked, or the last "
                     "was measured on nothing."))
};

struct SufficientData {
  SufficientVerdictBits verdicts;
  std::optional<NamedValues<ComparisonBitsData>> comparisons;

  AXISCERT_FIELDS(SufficientData, inlined(&SufficientData::verdicts),
                  AXISCERT_OPTIONAL_FIELD(comparisons, "By comparison."))
};

struct NumberFormatData {
  Name number;
  int bits = 0;
  int e_min = 0, e_max = 0;
  Overflow overflow = Overflow::infinity;

  AXISCERT_FIELDS(
      NumberFormatData, AXISCERT_FIELD(number, "Its name, as --number takes it."),
      AXISCERT_FIELD(bits, "Bits of the significand, the leading one included."),
      AXISCERT_FIELD(e_min, "The least exponent e of normal numbers m 2^e, 1 <= m < 2; below it underflow is gradual."),
      AXISCERT_FIELD(e_max, "The greatest."),
      AXISCERT_FIELD(overflow, "What a result beyond the greatest number becomes."))
};

// The rate of wrong verdicts.
struct WrongRateData {
  double rate = 0, low = 0, high = 0;

  static constexpr std::string_view about =
      "The rate of wrong verdicts with its limits (Wilson), 95 %; null without queries. Queries of one triangle or "
      "image group count as one.";
  AXISCERT_FIELDS(WrongRateData, AXISCERT_FIELD(rate, "Wrong verdicts over queries.", "share"),
                  AXISCERT_FIELD(low, "Its lower limit.", "share"),
                  AXISCERT_FIELD(high, "Its upper limit; of 0 wrong verdicts, the rate that they exclude.", "share"))
};

struct PrecisionStepData {
  Name number;
  int bits = 0;
  std::optional<std::uint64_t> rounding_seed;
  std::optional<WrongRateData> unlimited_rate, limited_rate;
  PrecisionStep step;

  static constexpr std::string_view about = PrecisionStep::about;
  AXISCERT_FIELDS(PrecisionStepData, AXISCERT_FIELD(number, "The format."),
                  AXISCERT_FIELD(bits, "Its bits of precision."),
                  AXISCERT_FIELD(rounding_seed, "The seed of rounding by chance; null: it is not."),
                  AXISCERT_FIELD(unlimited_rate, WrongRateData::about),
                  AXISCERT_FIELD(limited_rate, "The same with the exponents of the format."), inlined(&Of::step))
};

struct KernelPrecisionData {
  VerdictFlips exact;
  std::vector<PrecisionStepData> precisions;

  AXISCERT_FIELDS(KernelPrecisionData, AXISCERT_FIELD(exact, "Wrong verdicts of the formulae in exact arithmetic."),
                  AXISCERT_FIELD(precisions, "One for each format, and of rounding by chance for each seed."))
};

struct PrecisionTallyData {
  std::uint64_t queries = 0;
  std::optional<SignedNumber> swept;  // of one source
  std::optional<double> scene_size;
  NamedValues<KernelPrecisionData> kernels;

  static constexpr std::string_view about = "Of some queries.";
  AXISCERT_FIELDS(
      PrecisionTallyData, AXISCERT_FIELD(queries, "Valid queries."), field(&PrecisionTallyData::swept, swept_field),
      AXISCERT_OPTIONAL_FIELD(scene_size,
                              "Of a family whose offset is swept: the median size of its scenes, the greatest distance "
                              "of a vertex from the centre in one coordinate, or the radius.",
                              "units of length"),
      AXISCERT_FIELD(kernels, "By kernel."))
};

struct PrecisionData : CommandData<PrecisionData> {
  static constexpr std::string_view format = "axiscert-precision/3", title = "What precision costs";
  Precision precision = Precision::binary32;
  std::uint64_t trials = 0;
  WholeNumber seed;
  std::vector<NumberFormatData> numbers;
  RoundingRule rounding = RoundingRule::nearest;
  std::vector<std::uint64_t> rounding_seeds;
  Contraction contraction = Contraction::none;
  bool inputs_are_rounded = false;
  std::optional<SweepData> sweep;
  NamedValues<SufficientData> sufficient;
  PrecisionTallyData all;
  NamedValues<PrecisionTallyData> families;

  static constexpr std::string_view about =
      "precision.json, which `axiscert precision` writes. It depends on the command alone.";
  AXISCERT_FIELDS(PrecisionData, base<Of, CommandData<Of>>(),
                  AXISCERT_FIELD(precision, "The precision of the queries."),
                  AXISCERT_FIELD(trials, "Queries of each family."), AXISCERT_FIELD(seed, "The seed of every family."),
                  AXISCERT_FIELD(numbers, "The formats, by bits."),
                  AXISCERT_FIELD(rounding, "How each operation is rounded."),
                  AXISCERT_FIELD(rounding_seeds, "The seeds of rounding by chance; empty: it is not."),
                  AXISCERT_FIELD(contraction, "Which operations are fused."),
                  AXISCERT_FIELD(inputs_are_rounded,
                                 "Whether the queries are rounded to the format before anything is asked of them; else "
                                 "they are taken as they are."),
                  field(&Of::sweep, SweepData::in_data),
                  AXISCERT_FIELD(sufficient, "The least bits from which on nothing flips, by kernel."),
                  AXISCERT_FIELD(all, "Over all families."), AXISCERT_FIELD(families, "By family."))
};

// `tallies` by source; `command` produces them again.
InstrumentReport precision_report(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies,
                                  const std::string& command);

// In precision_plots.cpp.

std::string exponents_text(const PrecisionPlan& plan, ExponentRange range);
inline auto wrong_in(ExponentRange range) {
  return [range](const PrecisionStep& step) { return step.in(range).verdict.total(); };
}
// How many queries share a triangle or an image group, on average: of a source, and of all together.
double cluster_size(const PrecisionPlan& plan, std::size_t source);
double cluster_size(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies);
// A rate with its limits, where clusters of so many trials fail together: the most that they can depend on each other.
std::optional<WrongRateData> rate_with_limits(std::uint64_t failures, std::uint64_t trials, double size);
std::vector<InstrumentPlot> precision_plots(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies,
                                            const PrecisionTally& all);

}  // namespace axiscert
