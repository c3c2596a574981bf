// `axiscert condition`: whether flips come from the query's condition or from the formula, by kernel, family and
// comparison.
#include "reports/instrument/condition_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "fuzz/text/json_form.h"
#include "fuzz/text/merge.h"
#include "kernel/sphere_triangle/names.h"
#include "reports/instrument/figures.h"

namespace axiscert {
namespace {

class ConditionReport {
 public:
  ConditionReport(const ConditionPlan& plan, const ConditionResult& result)
      : plan_(plan), result_(result), origin_{plan.seed, plan.precision} {}

  InstrumentReport report(const std::string& command) const {
    const bool is_of_nothing = std::ranges::all_of(result_.valid, [](std::uint64_t valid) { return valid == 0; });
    InstrumentReport report{
        "condition",
        fmt::format("{}Flips caused by the query's condition and by the formula, {}, at most {} queries of each source",
                    is_of_nothing ? "Nothing was measured. " : "", name(plan_.precision), thousands(plan_.trials)),
        command,
        notes(),
        {by_family(), by_comparison(), wrong_verdicts()},
        {distribution()},
        data(command)};
    report.is_of_nothing = is_of_nothing;
    return report;
  }

 private:
  using Cell = ConditionCell;

  int digits() const {
    return plan_.precision == Precision::binary32 ? std::numeric_limits<float>::digits
                                                  : std::numeric_limits<double>::digits;
  }
  double in_u(double depth) const { return std::ldexp(depth, digits()); }
  const Source& source(std::size_t s) const { return *plan_.sources[s]; }

  std::vector<std::string> notes() const {
    return {
        fmt::format(
            "A flip: the kernel's answer to one of its sixteen comparisons differs from that of its own formulae in "
            "exact "
            "arithmetic. kappa = sum |x_i dm/dx_i| / |m| over the query's thirteen numbers, m = lhs - rhs; u = 2^-{}. "
            "Ill-conditioned: kappa u >= 1, the rounding of the query alone may turn the sign (to first order), and a "
            "tie, m = 0, always. Unstable: kappa u < 1, the formula is the cause; range: those of them that would be "
            "right if the "
            "exponent "
            "were unbounded. Undefined: 0/0 in exact arithmetic, there is no m. Not decided: m has no derivative.",
            digits()),
        fmt::format(
            "Whether kappa u is below 1 is decided exactly; its figures have six digits. The instrument evaluates "
            "the first {} "
            "flips by position of each kernel, family and comparison, and up to {} queries a family, evenly "
            "spaced, for "
            "the comparisons that did not flip. The least kappa u of an unstable flip leaves range faults out.",
            thousands(plan_.flip_limit), thousands(plan_.sample)),
        "For verdicts that differ from the geometry, the depth in u: how far the centre has to move for the answer "
        "to "
        "be right, relative to the greatest of |A-P|, |B-P|, |C-P| and r. The median is the lower one.",
        "Ill-conditioned excuses a formula; it does not say that no formula does better. kappa is relative to the "
        "numbers as given: a scene far from the origin "
        "is "
        "ill-conditioned because its coordinates are, whatever the formula."};
  }

  static std::vector<std::string> count_cells(const ConditionCounts& c) {
    std::vector<std::string> cells;
    for (const auto n :
         {c.flips, c.evaluated, c.ill_conditioned, c.ties, c.unstable, c.range, c.undefined, c.not_decided}) {
      cells.push_back(thousands(n));
    }
    return cells;
  }

  InstrumentTable by_family() const {
    InstrumentTable table{
        "Flips by kernel and family",
        {"kernel", "family", "flips", "evaluated", "ill-conditioned", "ties", "unstable", "range", "undefined",
         "not decided", "greatest kappa u of a right one", "least of an unstable flip", "address"},
        {}};
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      for (std::size_t s = 0; s < plan_.sources.size(); ++s) {
        const ConditionCounts counts = result_.cells[k][s].total();
        std::vector<std::string> row = {plan_.kernels[k]->id, source(s).name()};
        if (result_.valid[s] == 0) {
          row.resize(table.columns.size(), "not measured");
          table.rows.push_back(row);
          continue;
        }
        for (std::string& cell : count_cells(counts)) row.push_back(std::move(cell));
        row.push_back(counts.greatest_right ? shown(counts.greatest_right->value) : "none");
        row.push_back(counts.least_unstable ? shown(counts.least_unstable->value) : "none");
        row.push_back(counts.least_unstable ? origin_.address(source(s), counts.least_unstable->position) : "");
        table.rows.push_back(row);
      }
    }
    return table;
  }

  // The sum of one comparison of a kernel over the families, and the family that has its least unstable flip.
  std::pair<ConditionCounts, std::size_t> over_families(std::size_t k, std::size_t comparison) const {
    ConditionCounts sum;
    std::optional<MeasuredValue> least;
    std::size_t family = 0;
    for (std::size_t s = 0; s < plan_.sources.size(); ++s) {
      const ConditionCounts& counts = result_.cells[k][s].comparisons[comparison];
      merge_fields(sum, counts);
      if (counts.least_unstable && (!least || counts.least_unstable->value < least->value)) {
        least = counts.least_unstable;
        family = s;
      }
    }
    sum.least_unstable = least;
    return {sum, family};
  }

  InstrumentTable by_comparison() const {
    InstrumentTable table{"Flips by kernel and comparison, over these families (comparisons without a flip left out)",
                          {"kernel", "comparison", "flips", "evaluated", "ill-conditioned", "ties", "unstable", "range",
                           "undefined", "not decided", "least kappa u of an unstable flip", "address"},
                          {}};
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      for (std::size_t i = 0; i < comparison_count; ++i) {
        const auto [counts, s] = over_families(k, i);
        if (counts.flips == 0) continue;
        std::vector<std::string> row = {plan_.kernels[k]->id, std::string(comparisons[i].name)};
        for (std::string& cell : count_cells(counts)) row.push_back(std::move(cell));
        row.push_back(counts.least_unstable ? shown(counts.least_unstable->value) : "none");
        row.push_back(counts.least_unstable ? origin_.address(source(s), counts.least_unstable->position) : "");
        table.rows.push_back(row);
      }
    }
    return table;
  }

  InstrumentTable wrong_verdicts() const {
    InstrumentTable table{
        "Wrong verdicts, and the backward error in P",
        {"kernel", "family", "missed contacts", "phantom contacts", "median depth, u", "worst depth, u", "address"},
        {}};
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      for (std::size_t s = 0; s < plan_.sources.size(); ++s) {
        const Cell& cell = result_.cells[k][s];
        std::vector<std::string> row = {plan_.kernels[k]->id, source(s).name(), thousands(cell.false_separation),
                                        thousands(cell.false_contact)};
        if (result_.valid[s] == 0) {
          row.resize(2);
          row.resize(table.columns.size(), "not measured");
        } else if (cell.deepest) {
          row.insert(row.end(), {amount(in_u(median(cell)), 4), amount(in_u(cell.deepest->depth), 4),
                                 origin_.address(source(s), cell.deepest->position)});
        } else {
          row.insert(row.end(), {"none", "none", ""});
        }
        table.rows.push_back(row);
      }
    }
    return table;
  }

  static double median(const Cell& cell) { return cell.depths[(cell.depths.size() - 1) / 2]; }

  // Evaluated at powers of two between 2^-40 and 2^40.
  InstrumentPlot distribution() const {
    InstrumentPlot plot{"Condition of the evaluated flips: unstable below 1, ill-conditioned from 1",
                        "kappa u",
                        "flips with at most this kappa u, %",
                        InstrumentPlot::Kind::line,
                        true,
                        false,
                        {}};
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      const auto& values = result_.flip_kappa_u[k];
      if (values.empty()) continue;
      InstrumentSeries series{plan_.kernels[k]->id, {}, {}};
      std::size_t below = 0;
      for (int e = -40; e <= 40 && below < values.size(); ++e) {
        const double x = std::ldexp(1.0, e);
        while (below < values.size() && values[below].value() <= x) ++below;
        if (below > 0)
          series.points.emplace_back(x, 100 * static_cast<double>(below) / static_cast<double>(values.size()));
      }
      plot.series.push_back(series);
    }
    return plot;
  }

  ConditionCountsData data_of(const ConditionCounts& counts, const Source& source) const {
    const auto at = [&](const std::optional<MeasuredValue>& found) {
      return found ? std::optional(KappaAt{found->value, origin_.address(source, found->position)}) : std::nullopt;
    };
    return {counts, at(counts.least_unstable), at(counts.greatest_right)};
  }

  ConditionRow row_of(std::size_t k, std::size_t s) const {
    const Cell& cell = result_.cells[k][s];
    ConditionRow row{plan_.kernels[k]->id,
                     source(s).name(),
                     swept_value(source(s)),
                     result_.valid[s],
                     result_.invalid[s],
                     data_of(cell.total(), source(s)),
                     {},
                     {}};
    for (std::size_t i = 0; i < comparison_count; ++i)
      row.comparisons.put(comparisons[i].name) = data_of(cell.comparisons[i], source(s));
    row.wrong_verdicts = {cell.false_separation, cell.false_contact, {}, {}, {}};
    if (cell.deepest) {
      row.wrong_verdicts.median_depth_u = in_u(median(cell));
      row.wrong_verdicts.worst_depth_u = in_u(cell.deepest->depth);
      row.wrong_verdicts.worst_address = origin_.address(source(s), cell.deepest->position);
    }
    return row;
  }

  Json data(const std::string& command) const {
    ConditionData data;
    data.command = command;
    data.precision = plan_.precision;
    data.trials = plan_.trials;
    data.seed = {plan_.seed};
    data.sweep = sweep_of(plan_.sources);
    data.flip_limit = plan_.flip_limit;
    data.sample = plan_.sample;
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      for (std::size_t s = 0; s < plan_.sources.size(); ++s) data.rows.push_back(row_of(k, s));
    }
    return json_of(data);
  }

  const ConditionPlan& plan_;
  const ConditionResult& result_;
  QueryOrigin origin_;
};

}  // namespace

InstrumentReport condition_report(const ConditionPlan& plan, const ConditionResult& result,
                                  const std::string& command) {
  InstrumentReport report = ConditionReport(plan, result).report(command);
  const auto flips = [&](std::size_t k, std::size_t s) {
    return std::optional(SweepY{static_cast<double>(result.cells[k][s].total().flips)});
  };
  if (auto plot = sweep_plot(plan.sources, "Flips over the swept parameter; none has no point", "flips",
                             ids_of(plan.kernels), flips))
    report.plots.push_back(*plot);
  return report;
}

}  // namespace axiscert
