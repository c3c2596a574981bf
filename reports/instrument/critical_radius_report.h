// The report of `axiscert critical-radius`.
#pragma once

#include "fuzz/text/values.h"
#include "fuzz/instruments/critical_radius.h"
#include "reports/instrument/data.h"
#include "reports/instrument/sweep_axis.h"
#include "reports/instrument/instrument.h"

namespace axiscert {
// critical-radius.json: what `axiscert critical-radius` writes.

struct UlpsAt {
  Decimal6 ulps;
  Name address;

  AXISCERT_FIELDS(UlpsAt, AXISCERT_FIELD(ulps, "The error."), AXISCERT_FIELD(address, "Its query."))
};

// The errors of one kernel, over all families or on one.
struct CriticalRadiiData {
  std::uint64_t measured = 0;
  std::optional<std::uint64_t> right, within_1_ulp;
  std::optional<Decimal6> median_ulps, p99_ulps;
  std::optional<std::uint64_t> early, late, unbounded, not_monotone;
  std::uint64_t undecided = 0, invalid = 0, unanswered = 0, outside_limits = 0;

  AXISCERT_FIELDS(
      CriticalRadiiData, AXISCERT_FIELD(measured, "Triangles that were measured."),
      AXISCERT_FIELD(right, "Exactly right: the least float that is not below the distance; null: none was measured."),
      AXISCERT_FIELD(within_1_ulp, "At most an ulp off; null: none was measured."),
      AXISCERT_FIELD(median_ulps, "The median error, in ulps of the exact distance; null: none measured, or infinite.",
                     "ulps"),
      AXISCERT_FIELD(p99_ulps, "The 99 % quantile.", "ulps"),
      AXISCERT_FIELD(early, "A contact for a radius below the distance; null: none was measured."),
      AXISCERT_FIELD(late, "Separated for a radius that is not below the distance; null: none was measured."),
      AXISCERT_FIELD(unbounded, "Separated at the greatest finite radius; null: none was measured."),
      AXISCERT_FIELD(not_monotone, "Contact at a radius and separated at a greater one; null: none was measured."),
      AXISCERT_FIELD(undecided, "Triangles not measured: it declined at some radius."),
      AXISCERT_FIELD(invalid, "Triangles not measured: it called the query invalid at some radius."),
      AXISCERT_FIELD(unanswered, "Triangles not measured: it gave no answer at some radius."),
      AXISCERT_FIELD(outside_limits, "Triangles not measured: outside its limits."))
};

struct CriticalRadiusTotal {
  Name kernel;
  CriticalRadiiData radii;

  AXISCERT_FIELDS(CriticalRadiusTotal, AXISCERT_FIELD(kernel, "The kernel."), inlined(&CriticalRadiusTotal::radii))
};

struct CriticalRadiusRow {
  Name kernel, family;
  std::optional<SignedNumber> swept;
  CriticalRadiiData radii;
  std::uint64_t left_out = 0;
  std::optional<UlpsAt> worst_early, worst_late;
  std::optional<std::array<QueryLine, 2>> not_monotone_witness;

  AXISCERT_FIELDS(
      CriticalRadiusRow, AXISCERT_FIELD(kernel, "The kernel."), AXISCERT_FIELD(family, "The family."),
      field(&Of::swept, swept_field), inlined(&Of::radii),
      AXISCERT_FIELD(left_out, "Queries that are not valid, or farther away than the greatest radius."),
      AXISCERT_FIELD(worst_early, "The greatest error of a contact too early; null: none."),
      AXISCERT_FIELD(worst_late, "The greatest error of one too late; null: none."),
      AXISCERT_FIELD(not_monotone_witness,
                     "Two lines of a query file: a contact, and separated at a greater radius; null: none."))
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
  AXISCERT_FIELDS(CriticalRadiusData, base<Of, CommandData<Of>>(),
                  AXISCERT_FIELD(precision, "The precision of the queries."),
                  AXISCERT_FIELD(trials, "Triangles of each family."),
                  AXISCERT_FIELD(seed, "The seed of every family."), field(&Of::sweep, SweepData::in_data),
                  AXISCERT_FIELD(totals, "One for each kernel, over all families."),
                  AXISCERT_FIELD(rows, "One for each kernel and family."))
};

// Each kernel of which no triangle was measured, with the reasons.
std::vector<std::string> unmeasured_kernels(const CriticalRadiusPlan& plan, const CriticalRadiusResult& result);

InstrumentReport critical_radius_report(const CriticalRadiusPlan& plan, const CriticalRadiusResult& result,
                                        const std::string& command);

}  // namespace axiscert
