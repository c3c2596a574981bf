// The report of `axiscert precision`.
#pragma once

#include "fuzz/fields/field.h"
#include "fuzz/sphere_triangle/formulae/precision.h"
#include "reports/instrument/data.h"
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

struct PrecisionStepData {
  int bits = 0;
  PrecisionStep step;

  static constexpr std::string_view about = PrecisionStep::about;
  static constexpr auto fields(auto&& visit) {
    return visit(field(&PrecisionStepData::bits, {"bits", "Bits of precision."}), inlined(&PrecisionStepData::step));
  }
};

struct KernelPrecisionData {
  VerdictFlips exact;
  std::vector<PrecisionStepData> precisions;

  static constexpr auto fields(auto&& visit) {
    using Of = KernelPrecisionData;
    return visit(field(&Of::exact, {"exact", "Wrong verdicts of the formulae in exact arithmetic."}),
                 field(&Of::precisions, {"precisions", "One for each number of bits."}));
  }
};

struct PrecisionTallyData {
  std::uint64_t queries = 0;
  NamedValues<KernelPrecisionData> kernels;

  static constexpr std::string_view about = "Of some queries.";
  static constexpr auto fields(auto&& visit) {
    return visit(field(&PrecisionTallyData::queries, {"queries", "Valid queries."}),
                 field(&PrecisionTallyData::kernels, {"kernels", "By kernel."}));
  }
};

struct PrecisionData : CommandData<PrecisionData> {
  static constexpr std::string_view format = "axiscert-precision/2", title = "What precision costs";
  Precision precision = Precision::binary32;
  std::uint64_t trials = 0;
  WholeNumber seed;
  std::vector<int> bits;
  NamedValues<SufficientData> sufficient;
  PrecisionTallyData all;
  NamedValues<PrecisionTallyData> families;

  static constexpr std::string_view about =
      "precision.json, which `axiscert precision` writes. It depends on the command alone.";
  static constexpr auto fields(auto&& visit) {
    using Of = PrecisionData;
    return visit(base<Of, CommandData<Of>>(), field(&Of::precision, {"precision", "The precision of the queries."}),
                 field(&Of::trials, {"trials", "Queries of each family."}),
                 field(&Of::seed, {"seed", "The seed of every family."}),
                 field(&Of::bits, {"bits", "The numbers of bits."}),
                 field(&Of::sufficient, {"sufficient", "The least bits from which on nothing flips, by kernel."}),
                 field(&Of::all, {"all", "Over all families."}), field(&Of::families, {"families", "By family."}));
  }
};

// `tallies` by source; `command` produces them again.
InstrumentReport precision_report(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies,
                                  const std::string& command);

}  // namespace axiscert
