// The report of `axiscert condition`.
#pragma once

#include <cstdint>

#include "fuzz/sphere_triangle/formulae/condition.h"
#include "fuzz/text/field.h"
#include "reports/instrument/data.h"
#include "reports/instrument/instrument.h"
#include "reports/instrument/sweep_axis.h"

namespace axiscert {
// condition.json: what `axiscert condition` writes.

struct KappaAt {
  Decimal6 kappa_u;
  Name address;

  AXISCERT_FIELDS(KappaAt, AXISCERT_FIELD(kappa_u, "kappa times u."), AXISCERT_FIELD(address, "Its query."))
};

struct ConditionCountsData {
  ConditionCounts counts;
  std::optional<KappaAt> least_unstable, greatest_right;

  static constexpr std::string_view about = "Of one comparison, or of all together.";
  AXISCERT_FIELDS(ConditionCountsData, inlined(&Of::counts),
                  AXISCERT_FIELD(least_unstable, "The least kappa u of an unstable flip; null: none."),
                  AXISCERT_FIELD(greatest_right, "The greatest kappa u of a right one; null: none."))
};

struct WrongVerdictsData {
  std::uint64_t false_separation = 0, false_contact = 0;
  std::optional<double> median_depth_u, worst_depth_u;
  std::optional<Name> worst_address;

  static constexpr std::string_view about = "Wrong verdicts against the geometry.";
  AXISCERT_FIELDS(WrongVerdictsData, AXISCERT_FIELD(false_separation, "Missed contacts."),
                  AXISCERT_FIELD(false_contact, "Phantom contacts."),
                  AXISCERT_FIELD(median_depth_u, "Their median depth; null: none.", "u"),
                  AXISCERT_FIELD(worst_depth_u, "The greatest; null: none.", "u"),
                  AXISCERT_FIELD(worst_address, "Its query; null: none."))
};

struct ConditionRow {
  Name kernel, family;
  std::optional<SignedNumber> swept;
  std::uint64_t queries = 0, invalid = 0;
  ConditionCountsData total;
  NamedValues<ConditionCountsData> comparisons;
  WrongVerdictsData wrong_verdicts;

  static constexpr std::string_view about = "One kernel and family.";
  AXISCERT_FIELDS(ConditionRow, AXISCERT_FIELD(kernel, "The kernel."), AXISCERT_FIELD(family, "The family."),
                  field(&Of::swept, swept_field), AXISCERT_FIELD(queries, "Valid queries."),
                  AXISCERT_FIELD(invalid, "Queries that are not valid."),
                  field(&Of::total, figure_of("queries", "total", "All comparisons together.")),
                  AXISCERT_FIELD(comparisons, "By comparison."),
                  field(&Of::wrong_verdicts, figure_of("queries", "wrong_verdicts", WrongVerdictsData::about)))
};

struct ConditionData : CommandData<ConditionData> {
  static constexpr std::string_view format = "axiscert-condition/3",
                                    title = "Flips caused by the query and by the formula";
  Precision precision = Precision::binary32;
  std::uint64_t trials = 0;
  WholeNumber seed;
  std::optional<SweepData> sweep;
  std::uint64_t flip_limit = 0, sample = 0;
  std::vector<ConditionRow> rows;

  static constexpr std::string_view about =
      "condition.json, which `axiscert condition` writes. It depends on the command alone.";
  AXISCERT_FIELDS(ConditionData, base<Of, CommandData<Of>>(),
                  AXISCERT_FIELD(precision, "The precision of the queries."),
                  AXISCERT_FIELD(trials, "Queries of each family."), AXISCERT_FIELD(seed, "The seed of every family."),
                  field(&Of::sweep, SweepData::in_data),
                  AXISCERT_FIELD(flip_limit, "Flips examined of each kernel, family and comparison."),
                  AXISCERT_FIELD(sample, "Queries of a family whose right answers are examined."),
                  AXISCERT_FIELD(rows, "One for each kernel and family."))
};

InstrumentReport condition_report(const ConditionPlan& plan, const ConditionResult& result, const std::string& command);

}  // namespace axiscert
