// The report of `axiscert condition`.
#pragma once

#include "fuzz/fields/field.h"
#include "fuzz/sphere_triangle/formulae/condition.h"
#include "reports/instrument/data.h"
#include "reports/instrument/sweep_axis.h"
#include "reports/instrument/instrument.h"

namespace axiscert {
// condition.json: what `axiscert condition` writes.

struct KappaAt {
  Decimal6 kappa_u;
  Name address;

  static constexpr auto fields(auto&& visit) {
    return visit(field(&KappaAt::kappa_u, {"kappa_u", "kappa times u."}),
                 field(&KappaAt::address, {"address", "Its query."}));
  }
};

struct ConditionCountsData {
  ConditionCounts counts;
  std::optional<KappaAt> least_unstable, greatest_right;

  static constexpr std::string_view about = "Of one comparison, or of all together.";
  static constexpr auto fields(auto&& visit) {
    using Of = ConditionCountsData;
    return visit(inlined(&Of::counts),
                 field(&Of::least_unstable, {"least_unstable", "The least kappa u of an unstable flip; null: none."}),
                 field(&Of::greatest_right, {"greatest_right", "The greatest kappa u of a right one; null: none."}));
  }
};

struct WrongVerdictsData {
  std::uint64_t false_separation = 0, false_contact = 0;
  std::optional<double> median_depth_u, worst_depth_u;
  std::optional<Name> worst_address;

  static constexpr std::string_view about = "Wrong verdicts against the geometry.";
  static constexpr auto fields(auto&& visit) {
    using Of = WrongVerdictsData;
    return visit(field(&Of::false_separation, {"false_separation", "Missed contacts."}),
                 field(&Of::false_contact, {"false_contact", "Phantom contacts."}),
                 field(&Of::median_depth_u, {"median_depth_u", "Their median depth; null: none.", "u"}),
                 field(&Of::worst_depth_u, {"worst_depth_u", "The greatest; null: none.", "u"}),
                 field(&Of::worst_address, {"worst_address", "Its query; null: none."}));
  }
};

struct ConditionRow {
  Name kernel, family;
  std::optional<SignedNumber> swept;
  std::uint64_t invalid = 0;
  ConditionCountsData total;
  NamedValues<ConditionCountsData> comparisons;
  WrongVerdictsData wrong_verdicts;

  static constexpr std::string_view about = "One kernel and family.";
  static constexpr auto fields(auto&& visit) {
    using Of = ConditionRow;
    return visit(field(&Of::kernel, {"kernel", "The kernel."}), field(&Of::family, {"family", "The family."}),
                 field(&Of::swept, swept_field), field(&Of::invalid, {"invalid", "Queries that are not valid."}),
                 field(&Of::total, {"total", "All comparisons together."}),
                 field(&Of::comparisons, {"comparisons", "By comparison."}),
                 field(&Of::wrong_verdicts, {"wrong_verdicts", WrongVerdictsData::about}));
  }
};

struct ConditionData : CommandData<ConditionData> {
  static constexpr std::string_view format = "axiscert-condition/2",
                                    title = "Flips caused by the query and by the formula";
  Precision precision = Precision::binary32;
  std::uint64_t trials = 0;
  WholeNumber seed;
  std::optional<SweepData> sweep;
  std::uint64_t flip_limit = 0, sample = 0;
  std::vector<ConditionRow> rows;

  static constexpr std::string_view about =
      "condition.json, which `axiscert condition` writes. It depends on the command alone.";
  static constexpr auto fields(auto&& visit) {
    using Of = ConditionData;
    return visit(base<Of, CommandData<Of>>(), field(&Of::precision, {"precision", "The precision of the queries."}),
                 field(&Of::trials, {"trials", "Queries of each family."}),
                 field(&Of::seed, {"seed", "The seed of every family."}), field(&Of::sweep, SweepData::in_data),
                 field(&Of::flip_limit, {"flip_limit", "Flips examined of each kernel, family and comparison."}),
                 field(&Of::sample, {"sample", "Queries of a family whose right answers are examined."}),
                 field(&Of::rows, {"rows", "One for each kernel and family."}));
  }
};

InstrumentReport condition_report(const ConditionPlan& plan, const ConditionResult& result, const std::string& command);

}  // namespace axiscert
