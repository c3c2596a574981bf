// `axiscert critical-radius`: the error of the radius at which each kernel's answer changes.
#include "reports/instrument/critical_radius_report.h"

#include <fmt/format.h>

#include "fuzz/text/json_form.h"
#include "fuzz/text/merge.h"
#include "reports/instrument/figures.h"

namespace axiscert {
namespace {

const Decimal6 one_ulp = round_up(Rational(1));

// "44 declined, 2 called invalid": of the triangles that are not measured, why.
std::string not_measured_text(const CriticalRadii& cell, bool may_decline) {
  LookedAt looked_at;
  looked_at.undecided = cell.undecided;
  looked_at.invalid = cell.invalid;
  looked_at.unanswered = cell.unanswered;
  looked_at.outside_limits = cell.outside_limits;
  return not_decided_text(looked_at, may_decline);
}

class CriticalRadiusReport {
 public:
  CriticalRadiusReport(const CriticalRadiusPlan& plan, const CriticalRadiusResult& result)
      : plan_(plan), result_(result), origin_{plan.seed, plan.precision} {}

  InstrumentReport report(const std::string& command) const {
    InstrumentReport report{"critical-radius", title(),      command, notes(), {over_families(), by_family()},
                            {distribution()},  data(command)};
    report.add(reversals());
    return report;
  }

 private:
  std::string title() const {
    std::string text = fmt::format("Critical radii, {}, at most {} queries of each source", name(plan_.precision),
                                   thousands(plan_.trials));
    const std::vector<std::string> silent = unmeasured_kernels(plan_, result_);
    return silent.empty() ? text : fmt::format("Nothing was measured of {}. {}", fmt::join(silent, ", "), text);
  }

  const Source& source(std::size_t s) const { return *plan_.sources[s]; }

  std::vector<std::string> notes() const {
    std::vector<std::string> all = {
        "The critical radius: for fixed A, B, C, P the smallest radius for which a kernel says contact, by bisection "
        "over "
        "the floats. Exactly right: the least float that is not below the exact distance. The error is the distance "
        "from "
        "that one, in ulps of the exact distance, which is correctly rounded for that. Too early: contact for a radius "
        "below the distance, a phantom; too late: separated for one that is not below it, a missed contact. Unbounded: "
        "separated at the greatest finite radius; the median and the 99 % quantile count it as infinite.",
        "Of two boxes the radius is the half extent of A's first axis, and the distance that at which they touch, "
        "exactly.",
        "Figures over all families have each query with the same weight.",
        "An error can be many ulps long: those of a distance near 0 are short, the least subnormal for 0 itself.",
        "Not monotone: contact at a radius and separated at a greater one, among 0, the greatest finite radius, every "
        "power "
        "of two and every float within 32 of the kernel's and of the exact critical radius. None found proves nothing.",
        "Where the answers are not monotone, the critical radius is one of the radii at which they change. Queries "
        "that are "
        "not valid, and those farther away than the greatest radius, are left out. `axiscert run` measures from the "
        "distance "
        "rounded to nearest instead: its errors differ by up to one ulp."};
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      const CriticalRadii sum = this->all(k);
      if (std::string text = not_measured_text(sum, plan_.kernels[k]->may_decline); !text.empty()) {
        all.push_back(fmt::format("{}, not measured: triangles {}.", plan_.kernels[k]->id, text));
      }
    }
    return all;
  }

  static std::string share(std::uint64_t count, std::uint64_t of) {
    if (of == 0) return "not measured";
    return fmt::format("{:.2f}", 100 * static_cast<double>(count) / static_cast<double>(of));
  }
  static std::string quantile(const CriticalRadii& cell, double at) {
    if (cell.measured == 0) return "not measured";
    const auto error = cell.quantile(at);
    return error ? shown(*error) : "unbounded";
  }
  std::vector<std::string> columns(std::initializer_list<const char*> first) const {
    std::vector<std::string> all(first.begin(), first.end());
    for (const char* column : {"measured", "exactly right, %", "within 1 ulp, %", "median, ulps", "99 %, ulps",
                               "too early", "worst", "too late", "worst", "unbounded", "not monotone"}) {
      all.emplace_back(column);
    }
    if (!has_not_measured()) return all;
    for (const char* column : {"declined", "invalid", "unanswered", "outside limits"}) all.emplace_back(column);
    return all;
  }
  // Whether some triangle was not measured: only then there are columns for them.
  bool has_not_measured() const {
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      const CriticalRadii sum = all(k);
      if (sum.undecided + sum.invalid + sum.unanswered + sum.outside_limits != 0) return true;
    }
    return false;
  }
  static std::string worst(const std::optional<MeasuredValue>& measured) {
    return measured ? shown(measured->value) : "none";
  }
  void add_cells(std::vector<std::string>& row, const CriticalRadii& cell) const {
    if (cell.measured == 0) {
      row.emplace_back("0");
      row.insert(row.end(), 10, "not measured");
      return add_not_measured(row, cell);
    }
    row.insert(row.end(),
               {thousands(cell.measured), share(cell.right, cell.measured), share(cell.within(one_ulp), cell.measured),
                quantile(cell, 0.5), quantile(cell, 0.99), thousands(cell.early), worst(cell.worst_early),
                thousands(cell.late), worst(cell.worst_late), thousands(cell.unbounded), thousands(cell.reversals)});
    add_not_measured(row, cell);
  }
  void add_not_measured(std::vector<std::string>& row, const CriticalRadii& cell) const {
    if (!has_not_measured()) return;
    for (const std::uint64_t count : {cell.undecided, cell.invalid, cell.unanswered, cell.outside_limits}) {
      row.push_back(thousands(count));
    }
  }
  CriticalRadii all(std::size_t k) const {
    CriticalRadii sum;
    for (const CriticalRadii& cell : result_.cells[k]) merge_fields(sum, cell);
    return sum;
  }
  // The greater of the two worst errors.
  static std::optional<MeasuredValue> worst_of(const CriticalRadii& cell) {
    std::optional<MeasuredValue> found = cell.worst_early;
    if (cell.worst_late) keep_greatest(found, *cell.worst_late);
    return found;
  }

  InstrumentTable over_families() const {
    InstrumentTable table{"Over these families", columns({"kernel"}), {}};
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      std::vector<std::string> row = {plan_.kernels[k]->id};
      add_cells(row, all(k));
      table.rows.push_back(row);
    }
    return table;
  }

  InstrumentTable by_family() const {
    InstrumentTable table{"By family", columns({"kernel", "family"}), {}};
    table.columns.emplace_back("address of the worst");
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      for (std::size_t s = 0; s < plan_.sources.size(); ++s) {
        const CriticalRadii& cell = result_.cells[k][s];
        std::vector<std::string> row = {plan_.kernels[k]->id, source(s).name()};
        add_cells(row, cell);
        const auto found = worst_of(cell);
        row.push_back(found ? origin_.address(source(s), found->position) : "");
        table.rows.push_back(row);
      }
    }
    return table;
  }

  InstrumentTable reversals() const {
    InstrumentTable table{"Not monotone: the first of each kernel and family, as two lines of a query file",
                          {"kernel", "family", "query"},
                          {}};
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      for (std::size_t s = 0; s < plan_.sources.size(); ++s) {
        const auto& witness = result_.cells[k][s].first_reversal;
        if (!witness) continue;
        for (const std::string& line : {witness->contact, witness->separated}) {
          table.rows.push_back({plan_.kernels[k]->id, source(s).name(), line});
        }
      }
    }
    return table;
  }

  // Evaluated at powers of two up to the greatest error, at most 2^64.
  InstrumentPlot distribution() const {
    InstrumentPlot plot{"Error of the critical radius, over these families",
                        "error in ulps of the exact distance",
                        "triangles with at most this error, %",
                        InstrumentPlot::Kind::line,
                        true,
                        false,
                        {}};
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      const CriticalRadii sum = all(k);
      if (sum.errors.empty()) continue;
      InstrumentSeries series{plan_.kernels[k]->id, {}, {}};
      for (int e = -2; e <= 64; ++e) {
        const double x = std::ldexp(1.0, e);
        std::uint64_t count = 0;
        for (const auto& [error, n] : sum.errors) {
          if (error.value() <= x) count += n;
        }
        series.points.emplace_back(x, 100 * static_cast<double>(count) / static_cast<double>(sum.measured));
        if (sum.errors.rbegin()->first.value() <= x) break;
      }
      plot.series.push_back(series);
    }
    return plot;
  }

  static CriticalRadiiData data_of(const CriticalRadii& cell) {
    const auto of_measured = [&](std::uint64_t count) {
      return cell.measured == 0 ? std::nullopt : std::optional(count);
    };
    return {cell.measured,
            of_measured(cell.right),
            of_measured(cell.within(one_ulp)),
            cell.quantile(0.5),
            cell.quantile(0.99),
            of_measured(cell.early),
            of_measured(cell.late),
            of_measured(cell.unbounded),
            of_measured(cell.reversals),
            cell.undecided,
            cell.invalid,
            cell.unanswered,
            cell.outside_limits};
  }

  CriticalRadiusRow row_of(std::size_t k, std::size_t s) const {
    const CriticalRadii& cell = result_.cells[k][s];
    const auto worst_at = [&](const std::optional<MeasuredValue>& worst) {
      return worst ? std::optional(UlpsAt{worst->value, origin_.address(source(s), worst->position)}) : std::nullopt;
    };
    CriticalRadiusRow row{plan_.kernels[k]->id, source(s).name(),           swept_value(source(s)),    data_of(cell),
                          result_.left_out[s],  worst_at(cell.worst_early), worst_at(cell.worst_late), {}};
    if (const auto& reversal = cell.first_reversal) row.not_monotone_witness = {reversal->contact, reversal->separated};
    return row;
  }

  Json data(const std::string& command) const {
    CriticalRadiusData data;
    data.command = command;
    data.precision = plan_.precision;
    data.trials = plan_.trials;
    data.seed = {plan_.seed};
    data.sweep = sweep_of(plan_.sources);
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      data.totals.push_back({plan_.kernels[k]->id, data_of(all(k))});
      for (std::size_t s = 0; s < plan_.sources.size(); ++s) data.rows.push_back(row_of(k, s));
    }
    return json_of(data);
  }

  const CriticalRadiusPlan& plan_;
  const CriticalRadiusResult& result_;
  QueryOrigin origin_;
};

}  // namespace

std::vector<std::string> unmeasured_kernels(const CriticalRadiusPlan& plan, const CriticalRadiusResult& result) {
  std::vector<std::string> silent;
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    CriticalRadii sum;
    for (const CriticalRadii& cell : result.cells[k]) merge_fields(sum, cell);
    if (sum.measured != 0) continue;
    const std::string why = not_measured_text(sum, plan.kernels[k]->may_decline);
    silent.push_back(why.empty() ? plan.kernels[k]->id : fmt::format("{} ({})", plan.kernels[k]->id, why));
  }
  return silent;
}

InstrumentReport critical_radius_report(const CriticalRadiusPlan& plan, const CriticalRadiusResult& result,
                                        const std::string& command) {
  InstrumentReport report = CriticalRadiusReport(plan, result).report(command);
  const auto median = [&](std::size_t k, std::size_t s) {
    const CriticalRadii& cell = result.cells[k][s];
    const auto error = cell.measured == 0 ? std::nullopt : cell.quantile(0.5);
    return error && std::isfinite(error->value()) ? std::optional(SweepY{error->value()}) : std::nullopt;
  };
  if (auto plot = sweep_plot(plan.sources, "Median error over the swept parameter; 0 has no point",
                             "ulps of the exact distance", ids_of(plan.kernels), median))
    report.plots.push_back(*plot);
  return report;
}

}  // namespace axiscert
