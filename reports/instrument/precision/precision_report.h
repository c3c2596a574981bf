// The report of `axiscert precision`.
#pragma once

#include "fuzz/fields/field.h"
#include "fuzz/sphere_triangle/formulae/precision.h"
#include "reports/instrument/data.h"
#include "reports/instrument/sweep_axis.h"
#include "reports/instrument/instrument.h"

namespace axiscert {
// precision.json: what `axiscert precision` writes.

struct IntegerBitsData {
  int per_bit = 0, constant = 0;

  static constexpr auto fields(auto&& visit) {
    return visit(field(&IntegerBitsData::per_bit, {"per_bit", "Bits for each bit of the integers."}),
                 field(&IntegerBitsData::constant, {"constant", "And so many more."}));
  }
};

struct ComparisonBitsData {
  std::optional<double> degree_lhs, degree_rhs;
  std::optional<IntegerBitsData> integer_bits;
  std::optional<int> sufficient_bits;

  static constexpr auto fields(auto&& visit) {
    using Of = ComparisonBitsData;
    return visit(field(&Of::degree_lhs, {"degree_lhs", "The degree of the left side; null: it is zero."}),
                 field(&Of::degree_rhs, {"degree_rhs", "The degree of the right side."}),
                 field(&Of::integer_bits,
                       {"integer_bits",
                        "Enough to round nothing on integers of b bits; null for a form with roots or divisions."}),
                 field(&Of::sufficient_bits,
                       {"sufficient_bits",
                        "From so many bits on it does not flip on these queries; null: none of those asked."}));
  }
};

struct SufficientData {
  SufficientVerdictBits verdicts;
  std::optional<NamedValues<ComparisonBitsData>> comparisons;

  static constexpr auto fields(auto&& visit) {
    return visit(
        inlined(&SufficientData::verdicts),
        field(&SufficientData::comparisons, {.name = "comparisons", .about = "By comparison.", .may_be_absent = true}));
  }
};

struct NumberFormatData {
  Name number;
  int bits = 0;
  int e_min = 0, e_max = 0;
  Overflow overflow = Overflow::infinity;

  static constexpr auto fields(auto&& visit) {
    using Of = NumberFormatData;
    return visit(field(&Of::number, {"number", "Its name, as --number takes it."}),
                 field(&Of::bits, {"bits", "Bits of the significand, the leading one included."}),
                 field(&Of::e_min, {"e_min",
                                    "The least exponent e of normal numbers m 2^e, 1 <= m < 2; below it underflow is "
                                    "gradual."}),
                 field(&Of::e_max, {"e_max", "The greatest."}),
                 field(&Of::overflow, {"overflow", "What a result beyond the greatest number becomes."}));
  }
};

// The rate of wrong verdicts.
struct WrongRateData {
  double rate = 0, low = 0, high = 0;

  static constexpr std::string_view about =
      "The rate of wrong verdicts with its limits (Wilson), 95 %; null without queries. Queries of one triangle or "
      "image group count as one.";
  static constexpr auto fields(auto&& visit) {
    using Of = WrongRateData;
    return visit(
        field(&Of::rate, {"rate", "Wrong verdicts over queries.", "share"}),
        field(&Of::low, {"low", "Its lower limit.", "share"}),
        field(&Of::high, {"high", "Its upper limit; of 0 wrong verdicts, the rate that they exclude.", "share"}));
  }
};

struct PrecisionStepData {
  Name number;
  int bits = 0;
  std::optional<std::uint64_t> rounding_seed;
  std::optional<WrongRateData> unlimited_rate, limited_rate;
  PrecisionStep step;

  static constexpr std::string_view about = PrecisionStep::about;
  static constexpr auto fields(auto&& visit) {
    using Of = PrecisionStepData;
    return visit(field(&Of::number, {"number", "The format."}), field(&Of::bits, {"bits", "Its bits of precision."}),
                 field(&Of::rounding_seed, {"rounding_seed", "The seed of rounding by chance; null: it is not."}),
                 field(&Of::unlimited_rate, {"unlimited_rate", WrongRateData::about}),
                 field(&Of::limited_rate, {"limited_rate", "The same with the exponents of the format."}),
                 inlined(&Of::step));
  }
};

struct KernelPrecisionData {
  VerdictFlips exact;
  std::vector<PrecisionStepData> precisions;

  static constexpr auto fields(auto&& visit) {
    using Of = KernelPrecisionData;
    return visit(
        field(&Of::exact, {"exact", "Wrong verdicts of the formulae in exact arithmetic."}),
        field(&Of::precisions, {"precisions", "One for each format, and of rounding by chance for each seed."}));
  }
};

struct PrecisionTallyData {
  std::uint64_t queries = 0;
  std::optional<SignedNumber> swept;  // of one source
  std::optional<double> scene_size;
  NamedValues<KernelPrecisionData> kernels;

  static constexpr std::string_view about = "Of some queries.";
  static constexpr auto fields(auto&& visit) {
    return visit(field(&PrecisionTallyData::queries, {"queries", "Valid queries."}),
                 field(&PrecisionTallyData::swept, swept_field),
                 field(&PrecisionTallyData::scene_size,
                       {.name = "scene_size",
                        .about = "Of a family whose offset is swept: the median size of its scenes, the greatest "
                                 "distance of a vertex from the centre in one coordinate, or the radius.",
                        .unit = "units of length",
                        .may_be_absent = true}),
                 field(&PrecisionTallyData::kernels, {"kernels", "By kernel."}));
  }
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
  static constexpr auto fields(auto&& visit) {
    using Of = PrecisionData;
    return visit(
        base<Of, CommandData<Of>>(), field(&Of::precision, {"precision", "The precision of the queries."}),
        field(&Of::trials, {"trials", "Queries of each family."}),
        field(&Of::seed, {"seed", "The seed of every family."}),
        field(&Of::numbers, {"numbers", "The formats, by bits."}),
        field(&Of::rounding, {"rounding", "How each operation is rounded."}),
        field(&Of::rounding_seeds, {"rounding_seeds", "The seeds of rounding by chance; empty: it is not."}),
        field(&Of::contraction, {"contraction", "Which operations are fused."}),
        field(&Of::inputs_are_rounded, {"inputs_are_rounded",
                                        "Whether the queries are rounded to the format before anything is asked "
                                        "of them; else they are taken as they are."}),
        field(&Of::sweep, SweepData::in_data),
        field(&Of::sufficient, {"sufficient", "The least bits from which on nothing flips, by kernel."}),
        field(&Of::all, {"all", "Over all families."}), field(&Of::families, {"families", "By family."}));
  }
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
