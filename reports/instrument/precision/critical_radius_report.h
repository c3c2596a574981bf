// The report of `axiscert critical-radius`.
#pragma once

#include "fuzz/files/query_object.h"
#include "fuzz/instruments/critical_radius.h"
#include "reports/instrument/data.h"
#include "reports/instrument/sweep_axis.h"
#include "reports/instrument/instrument.h"

namespace axiscert {
// critical-radius.json: what `axiscert critical-radius` writes.

struct UlpsAt {
  Decimal6 ulps;
  Name address;

  static constexpr auto fields(auto&& visit) {
    return visit(field(&UlpsAt::ulps, {"ulps", "The error."}), field(&UlpsAt::address, {"address", "Its query."}));
  }
};

// The errors of one kernel, over all families or on one.
struct CriticalRadiiData {
  std::uint64_t measured = 0;
  std::optional<std::uint64_t> right, within_1_ulp;
  std::optional<Decimal6> median_ulps, p99_ulps;
  std::optional<std::uint64_t> early, late, unbounded, not_monotone;
  std::uint64_t undecided = 0, invalid = 0, unanswered = 0, outside_limits = 0;

  static constexpr auto fields(auto&& visit) {
    using Of = CriticalRadiiData;
    return visit(
        field(&Of::measured, {"measured", "Triangles that were measured."}),
        field(&Of::right,
              {"right", "Exactly right: the least float that is not below the distance; null: none was measured."}),
        field(&Of::within_1_ulp, {"within_1_ulp", "At most an ulp off; null: none was measured."}),
        field(&Of::median_ulps,
              {"median_ulps", "The median error, in ulps of the exact distance; null: none measured, or infinite.",
               "ulps"}),
        field(&Of::p99_ulps, {"p99_ulps", "The 99 % quantile.", "ulps"}),
        field(&Of::early, {"early", "A contact for a radius below the distance; null: none was measured."}),
        field(&Of::late, {"late", "Separated for a radius that is not below the distance; null: none was measured."}),
        field(&Of::unbounded, {"unbounded", "Separated at the greatest finite radius; null: none was measured."}),
        field(&Of::not_monotone,
              {"not_monotone", "Contact at a radius and separated at a greater one; null: none was measured."}),
        field(&Of::undecided, {"undecided", "Triangles not measured: it declined at some radius."}),
        field(&Of::invalid, {"invalid", "Triangles not measured: it called the query invalid at some radius."}),
        field(&Of::unanswered, {"unanswered", "Triangles not measured: it gave no answer at some radius."}),
        field(&Of::outside_limits, {"outside_limits", "Triangles not measured: outside its limits."}));
  }
};

struct CriticalRadiusTotal {
  Name kernel;
  CriticalRadiiData radii;

  static constexpr auto fields(auto&& visit) {
    return visit(field(&CriticalRadiusTotal::kernel, {"kernel", "The kernel."}), inlined(&CriticalRadiusTotal::radii));
  }
};

struct CriticalRadiusRow {
  Name kernel, family;
  std::optional<SignedNumber> swept;
  CriticalRadiiData radii;
  std::uint64_t left_out = 0;
  std::optional<UlpsAt> worst_early, worst_late;
  std::optional<std::array<QueryLine, 2>> not_monotone_witness;

  static constexpr auto fields(auto&& visit) {
    using Of = CriticalRadiusRow;
    return visit(
        field(&Of::kernel, {"kernel", "The kernel."}), field(&Of::family, {"family", "The family."}),
        field(&Of::swept, swept_field), inlined(&Of::radii),
        field(&Of::left_out, {"left_out", "Queries that are not valid, or farther away than the greatest radius."}),
        field(&Of::worst_early, {"worst_early", "The greatest error of a contact too early; null: none."}),
        field(&Of::worst_late, {"worst_late", "The greatest error of one too late; null: none."}),
        field(&Of::not_monotone_witness,
              {"not_monotone_witness",
               "Two lines of a query file: a contact, and separated at a greater radius; null: none."}));
  }
};

struct CriticalRadiusData : CommandData<CriticalRadiusData> {
  static constexpr std::string_view format = "axiscert-critical-radius/3", title = "Errors of the critical radius";
  Precision precision = Precision::binary32;
  std::uint64_t trials = 0;
  WholeNumber seed;
  std::optional<SweepData> sweep;
  std::vector<CriticalRadiusTotal> totals;
  std::vector<CriticalRadiusRow> rows;

  static constexpr std::string_view about =
      "critical-radius.json, which `axiscert critical-radius` writes. It depends on the command alone.";
  static constexpr auto fields(auto&& visit) {
    using Of = CriticalRadiusData;
    return visit(base<Of, CommandData<Of>>(), field(&Of::precision, {"precision", "The precision of the queries."}),
                 field(&Of::trials, {"trials", "Triangles of each family."}),
                 field(&Of::seed, {"seed", "The seed of every family."}), field(&Of::sweep, SweepData::in_data),
                 field(&Of::totals, {"totals", "One for each kernel, over all families."}),
                 field(&Of::rows, {"rows", "One for each kernel and family."}));
  }
};

// Each kernel of which no triangle was measured, with the reasons.
std::vector<std::string> unmeasured_kernels(const CriticalRadiusPlan& plan, const CriticalRadiusResult& result);

InstrumentReport critical_radius_report(const CriticalRadiusPlan& plan, const CriticalRadiusResult& result,
                                        const std::string& command);

}  // namespace axiscert
