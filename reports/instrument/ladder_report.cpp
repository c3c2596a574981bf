#include "reports/instrument/ladder_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fuzz/campaign/campaign.h"
#include "fuzz/sphere_triangle/formulae/ladder.h"
#include "fuzz/text/json_form.h"

namespace axiscert {

Json JsonForm<ErrorQuantile>::write(ErrorQuantile at) {
  return std::isfinite(at.value) ? Json(at.value) : Json("beyond binary64");
}
Json JsonForm<ErrorQuantile>::schema() { return {{"type", {"number", "string"}}, {"minimum", 0}}; }

namespace {

using Entries = std::vector<LadderEntry>;

std::string kind_text(AxisKind kind) { return std::string(axis_kind_names[kind]); }

bool has_sides(const LadderEntry& entry) { return entry.kernel->exposes == Exposure::sides; }

std::string quantile(const ComparisonAccuracy& accuracy, unsigned percent) {
  const auto value = accuracy.errors.quantile(percent);
  return value ? fmt::format("{:.4g}", *value) : "";
}
std::string worst(const ComparisonAccuracy& accuracy) {
  if (accuracy.errors.count() == 0) return "";
  const Decimal6 error = accuracy.errors.worst();
  return std::isfinite(error.value()) ? fmt::format("{:.6g}", error.value()) : error.text();  // six digits: all it has
}
std::string text(const std::optional<ExponentWindow>& window) {
  return window ? fmt::format("{}..{}", window->low, window->high) : "none";
}
std::string window_of(const LadderEntry& entry, AxisKind kind) {
  return text(common_window(entry.windows, axes_of_kind(kind)));
}
std::string ulps(double value) { return fmt::format("{:.4g}", value); }
std::string ns(double value) { return fmt::format("{:.1f}", value); }

// "20500 [18600, 22500]", of a million.
std::string rate_text(const LadderRateData& rate) {
  if (!rate.rate) return "";
  if (!rate.low || !rate.high) return fmt::format("{:.0f}", 1e6 * *rate.rate);
  return fmt::format("{:.0f} [{:.0f}, {:.0f}]", 1e6 * *rate.rate, 1e6 * *rate.low, 1e6 * *rate.high);
}

InstrumentTable kernels_table(const LadderPlan& plan, const LadderResult& result) {
  InstrumentTable table{"Kernels, by family: wrong verdicts, also per million with their limits, 95 %",
                        {"family", "kernel", "missed", "per million", "phantom", "per million", "touching flips",
                         "critical radius: median ulps", "worst ulps", "unbounded"},
                        {}};
  for (std::size_t s = 0; s < plan.sources.size(); ++s) {
    for (std::size_t k = 0; k < result.entries.size(); ++k) {
      const KernelAccuracy& here = result.entries[k].by_source[s];
      const auto& radii = here.radius_errors_ulps;
      table.rows.push_back(
          {plan.sources[s]->name(), result.entries[k].kernel->id, fmt::format("{}", here.false_separation),
           rate_text(ladder_rate(result, s, k, Figure::missed)), fmt::format("{}", here.false_contact),
           rate_text(ladder_rate(result, s, k, Figure::phantom)), fmt::format("{}", here.touching_flips),
           radii.empty() ? "" : ulps(radii[(radii.size() - 1) / 2]), radii.empty() ? "" : ulps(radii.back()),
           fmt::format("{}", here.radius_unbounded)});
      if (here.queries == 0) std::fill(table.rows.back().begin() + 2, table.rows.back().end(), "not measured");
    }
  }
  return table;
}

InstrumentTable windows_table(const Entries& entries) {
  InstrumentTable table{"Exponent windows, by axis", {"kernel"}, {}};
  for (const std::string_view axis : axis_names) table.columns.emplace_back(axis);
  for (const LadderEntry& entry : entries) {
    auto& row = table.rows.emplace_back(std::vector<std::string>{entry.kernel->id});
    for (const auto& window : entry.windows) row.push_back(text(window));
  }
  return table;
}

InstrumentTable families_table(const LadderPlan& plan, const Entries& entries) {
  InstrumentTable table{
      "By family: by kind of axis sign errors of comparisons and errors in u", {"family", "kernel"}, {}};
  table.heading_of.resize(table.columns.size());
  for (const AxisKind kind : enumerators<AxisKind>) {
    table.headings.push_back(kind_text(kind) + " axes");
    for (const char* what : {"signs", "by range", "median", "99 %", "worst"}) {
      table.columns.push_back(kind_text(kind) + " " + what);
      table.heading_of.push_back(table.headings.size());
    }
  }
  for (std::size_t s = 0; s < plan.sources.size(); ++s) {
    for (const LadderEntry& entry : entries) {
      const KernelAccuracy& here = entry.by_source[s];
      auto& row = table.rows.emplace_back(std::vector<std::string>{plan.sources[s]->name(), entry.kernel->id});
      for (const AxisKind kind : enumerators<AxisKind>) {
        const ComparisonAccuracy accuracy = here.of(comparisons_of_kind(kind));
        row.insert(row.end(), {fmt::format("{}", accuracy.sign_errors()), fmt::format("{}", accuracy.by_range),
                               has_sides(entry) ? quantile(accuracy, 50) : "no sides shown", quantile(accuracy, 99),
                               worst(accuracy)});
      }
    }
  }
  return table;
}

InstrumentTable costliest_table(const LadderPlan& plan, const Entries& entries, const std::vector<LadderStep>& steps) {
  InstrumentTable table{
      "The step that costs most, by family and kind of axis", {"family", "axes", "in", "step", "from", "to"}, {}};
  for (std::size_t s = 0; s < plan.sources.size(); ++s) {
    for (const AxisKind kind : enumerators<AxisKind>) {
      const CostliestSteps costliest = costliest_steps(entries, steps, kind, s);
      const auto add = [&](const std::string& family, const char* what, std::optional<std::size_t> i, auto&& shown_of) {
        if (!i) return;  // no step worsens it
        const LadderEntry &from = entries[steps[*i].from], &to = entries[steps[*i].to];
        table.rows.push_back({family, kind_text(kind), what, fmt::format("{} to {}", from.kernel->id, to.kernel->id),
                              shown_of(from), shown_of(to)});
      };
      const auto of = [&](const LadderEntry& entry) { return entry.by_source[s].of(comparisons_of_kind(kind)); };
      const std::string name = plan.sources[s]->name();
      add(name, "sign errors", costliest.sign_errors,
          [&](const LadderEntry& e) { return fmt::format("{}", of(e).sign_errors()); });
      add(name, "sign errors by rounding", costliest.rounding_sign_errors,
          [&](const LadderEntry& e) { return fmt::format("{}", of(e).rounding_sign_errors()); });
      add(name, "worst error, u", costliest.worst_error, [&](const LadderEntry& e) { return worst(of(e)); });
      // Windows are of no family.
      if (s == 0) add("", "range", costliest.range, [&](const LadderEntry& e) { return window_of(e, kind); });
    }
  }
  return table;
}

InstrumentTable times_table(const Entries& entries) {
  InstrumentTable table{"Times", {"kernel", "ns scalar", "ns best target"}, {}};
  for (const LadderEntry& entry : entries) {
    const auto& best = entry.speed->best_target;
    table.rows.push_back({entry.kernel->id, ns(entry.speed->scalar_ns),
                          best ? fmt::format("{} {}", ns(best->second), best->first) : ""});
  }
  return table;
}

InstrumentTable front_table(const Entries& entries) {
  InstrumentTable table{
      "The front: no kernel is both faster and wrong less often than one of these, each query of each family with the "
      "same weight",
      {"kernel", "ns scalar", "wrong verdicts per million"},
      {}};
  for (const std::size_t i : accuracy_speed_front(entries)) {
    table.rows.push_back({entries[i].kernel->id, ns(entries[i].speed->scalar_ns),
                          fmt::format("{:.1f}", entries[i].all.flips_per_million())});
  }
  return table;
}

// x is the position in the list of kernels: with the default kernels, rung k is at k.
template <class Shown>
InstrumentSeries by_kernel(std::string series_name, const Entries& entries, Shown&& figure) {
  InstrumentSeries series{std::move(series_name), {}, {}};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::optional<double> y = figure(entries[i]);
    if (!y || !std::isfinite(*y) || !(*y > 0)) continue;
    series.points.emplace_back(static_cast<double>(i), *y);
    series.labels.push_back(entries[i].kernel->id);
  }
  return series;
}

template <class Shown>
InstrumentPlot by_kind(std::string caption, std::string y_label, const LadderPlan& plan, const Entries& entries,
                       std::size_t source, Shown&& figure) {
  InstrumentPlot plot{std::move(caption), "kernel", std::move(y_label), InstrumentPlot::Kind::line, false, true, {}};
  for (const AxisKind kind : enumerators<AxisKind>) {
    plot.series.push_back(by_kernel(kind_text(kind), entries, [&](const LadderEntry& entry) -> std::optional<double> {
      return figure(entry.by_source[source].of(comparisons_of_kind(kind)));
    }));
  }
  plot.x_names = ids_of(plan.kernels);
  return plot;
}

void add_sweep_plot(InstrumentReport& report, const LadderPlan& plan, const Entries& entries) {
  const auto wrong = [&](std::size_t k, std::size_t s) {
    const KernelAccuracy& found = entries[k].by_source[s];
    return std::optional(SweepY{static_cast<double>(found.false_separation + found.false_contact)});
  };
  if (auto plot = sweep_plot(plan.sources, "Wrong verdicts over the swept parameter; none has no point", "queries",
                             ids_of(plan.kernels), wrong))
    report.plots.push_back(*plot);
}

void add_plots(InstrumentReport& report, const LadderPlan& plan, const Entries& entries) {
  for (std::size_t source = 0; source < plan.sources.size(); ++source) {
    const std::string family = plan.sources[source]->name();
    report.plots.push_back(by_kind("Median error by rung, " + family, "error, u", plan, entries, source,
                                   [](const ComparisonAccuracy& a) { return a.errors.quantile(50); }));
    report.plots.push_back(by_kind("Worst error by rung, " + family, "error, u", plan, entries, source,
                                   [](const ComparisonAccuracy& a) { return a.errors.worst().value(); }));
  }
  if (!plan.speed) return;
  const auto scalar_ns = [](const LadderEntry& entry) { return std::optional(entry.speed->scalar_ns); };
  report.plots.push_back({"Time by rung",
                          "kernel",
                          "ns a query, scalar",
                          InstrumentPlot::Kind::line,
                          false,
                          false,
                          {by_kernel("scalar", entries, scalar_ns)},
                          ids_of(plan.kernels)});
  InstrumentSeries front{"front", {}, {}}, others{"beaten", {}, {}};
  const auto best = accuracy_speed_front(entries);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    InstrumentSeries& series = std::find(best.begin(), best.end(), i) != best.end() ? front : others;
    series.points.emplace_back(entries[i].speed->scalar_ns, entries[i].all.flips_per_million());
    series.labels.push_back(entries[i].kernel->id);
  }
  report.plots.push_back({"Accuracy and speed",
                          "ns a query, scalar",
                          "wrong verdicts per million, each query of each family with the same weight",
                          InstrumentPlot::Kind::scatter,
                          false,
                          false,
                          {std::move(front), std::move(others)}});
}

std::vector<std::string> notes(const LadderPlan& plan, const Entries& entries) {
  std::vector<std::string> names;
  for (const SourcePtr& source : plan.sources) names.push_back(source->name());
  const ExponentWindow scanned = scanned_exponents(plan.precision);
  std::vector<std::string> all = {
      fmt::format("{}, at most {} queries of each source ({}), seed {}.", axiscert::name(plan.precision), plan.trials,
                  fmt::join(names, ", "), plan.seed),
      "Sign errors are flips of comparisons against the kernel's own formulae in exact arithmetic; verdict flips are "
      "against the geometric truth, in which touching is contact. By range are those that the same operations with an "
      "unbounded exponent get right; the others are by rounding.",
      "An error is |(l^ - r^) - (l - r)| / (u (|l| + |r|)). A side that is not finite is a range event and has none. "
      "The worst is exact, rounded up; the median and 99 % are lower order statistics, within one part in 2000.",
      "An error is relative to the sides of its own form, so two forms compare fully only where their sides do: "
      "squaring a radius comparison doubles the error of the same mistake, and a side comparison against zero, whose "
      "scale vanishes where it changes sign, has no bound where A.B > A.A has one. Sign errors, windows and the "
      "critical radius are free of that.",
      fmt::format("A window is the greatest interval of m around 0 in which multiplying 256 general queries, all far "
                  "from a change of sign, by 2^m changes no bit of the axis from what an unbounded exponent gives, and "
                  "no side is infinite or NaN. Scanned: {}..{}, beyond which a query cannot be scaled exactly.",
                  scanned.low, scanned.high),
      fmt::format("The critical radius is found for every {}th of a source's first {} queries.", critical_radius_stride,
                  critical_radius_queries),
      "The figures hold for these queries only and are not bounds."};
  if (plan.speed) {
    all.push_back(fmt::format(
        "ns: verdicts of {} distinct general queries, one thread, median of {} repetitions. Every kernel is timed in "
        "its scalar form; another arithmetic is called through a table query by query and not inlined. The least time "
        "is in the figures as well: a median far above it was disturbed.",
        speed_queries, speed_repetitions));
  }
  for (const LadderEntry& entry : entries) {
    if (!has_sides(entry)) all.push_back(entry.kernel->id + " does not show its sides: it has no errors here.");
  }
  return all;
}

}  // namespace

InstrumentReport ladder_report(const LadderPlan& plan, const LadderResult& result, const std::string& command) {
  const Entries& entries = result.entries;
  InstrumentReport report;
  report.name = "ladder";
  report.is_of_nothing = result.is_of_nothing();
  report.title = fmt::format("{}What each step of the derivation costs, {}",
                             report.is_of_nothing ? "Nothing was measured. " : "", axiscert::name(plan.precision));
  report.command = command;
  report.notes = notes(plan, entries);
  const std::vector<LadderStep> steps = ladder_steps(plan.kernels);
  const std::vector<LadderDifferenceData> differences = ladder_differences(plan, result);
  report.tables = {kernels_table(plan, result)};
  add_difference_tables(report, plan, result, differences);
  report.tables.push_back(families_table(plan, entries));
  report.tables.push_back(windows_table(entries));
  if (!steps.empty()) report.tables.push_back(costliest_table(plan, entries, steps));
  if (plan.speed) {
    report.tables.push_back(times_table(entries));
    report.tables.push_back(front_table(entries));
  }
  add_difference_plots(report, plan, result, differences);
  add_plots(report, plan, entries);
  add_sweep_plot(report, plan, entries);
  report.data = ladder_json(plan, result, differences, command);
  return report;
}

namespace {

WindowData window_data(const std::optional<ExponentWindow>& window) {
  return window ? WindowData({window->low, window->high}) : WindowData();
}

FiguresData figures_data(const ComparisonAccuracy& accuracy, bool has_sides) {
  FiguresData figures{accuracy, {}, {}, {}, {}, {}, {}};
  if (!has_sides) return figures;
  const ErrorSpread& errors = accuracy.errors;
  const auto at = [&](unsigned percent) {
    const std::optional<double> error = errors.quantile(percent);
    return error ? std::optional(ErrorQuantile{*error}) : std::nullopt;
  };
  figures.median_u.emplace(at(50));
  figures.p99_u.emplace(at(99));
  figures.worst_u.emplace(errors.count() == 0 ? std::nullopt : std::optional(errors.worst()));
  figures.errors = errors.count();
  figures.range_events = accuracy.range_events;
  figures.error_without_scale = accuracy.without_scale;
  return figures;
}

LadderResultData result_data(const KernelAccuracy& accuracy, bool has_sides) {
  LadderResultData result;
  result.queries = accuracy.queries;
  result.verdict = {accuracy.false_separation, accuracy.false_contact, accuracy.touching_flips,
                    accuracy.flips_per_million()};
  result.critical_radius = radius_summary(accuracy.radius_errors_ulps, accuracy.radius_unbounded);
  const auto of = [&](ComparisonBits which) { return figures_data(accuracy.of(which), has_sides); };
  for (std::size_t i = 0; i < axis_count; ++i) result.axes.put(axis_names[i]) = of(axis_comparisons[i]);
  for (std::size_t i = 0; i < axis_kind_count; ++i) {
    const ComparisonBits which = comparisons_of_kind(static_cast<AxisKind>(i));
    const auto radius = static_cast<ComparisonBits>(which & ~side_comparisons);
    const auto side = static_cast<ComparisonBits>(which & side_comparisons);
    KindData& kind = result.kinds.put(axis_kind_names[i]) = {of(which), of(radius), {}};
    if (side != 0) kind.side = of(side);
  }
  for (std::size_t i = 0; i < comparison_count; ++i)
    result.comparisons.put(comparisons[i].name) = figures_data(accuracy.comparisons[i], has_sides);
  return result;
}

LadderKernelData kernel_data(const LadderPlan& plan, const LadderResult& found, std::size_t k) {
  const LadderEntry& entry = found.entries[k];
  const bool has_sides = entry.kernel->exposes == Exposure::sides;
  LadderKernelData kernel{entry.kernel->id, entry.kernel->summary, has_sides, {}, {}};
  for (std::size_t i = 0; i < axis_count; ++i) kernel.windows.axes.put(axis_names[i]) = window_data(entry.windows[i]);
  for (const AxisKind kind : enumerators<AxisKind>) {
    kernel.windows.kinds.put(axis_kind_names[kind]) = window_data(common_window(entry.windows, axes_of_kind(kind)));
  }
  for (std::size_t s = 0; s < plan.sources.size(); ++s) {
    LadderResultData& result = kernel.families.put(plan.sources[s]->name()) =
        result_data(entry.by_source[s], has_sides);
    result.swept = swept_value(*plan.sources[s]);
    for (const Figure figure : enumerators<Figure>) {
      result.rates.put(figure_names[figure]) = ladder_rate(found, s, k, figure);
    }
  }
  return kernel;
}

LadderSpeedData speed_data(const std::vector<LadderEntry>& entries) {
  LadderSpeedData speed;
  for (const LadderEntry& entry : entries) {
    NamedValues<double>& kernel = speed.kernels.put(entry.kernel->id);
    kernel.put("scalar") = entry.speed->scalar_ns;
    kernel.put("scalar_least") = entry.speed->least_scalar_ns;
    if (const auto& best = entry.speed->best_target) kernel.put(best->first) = best->second;
  }
  for (const std::size_t i : accuracy_speed_front(entries)) speed.front.push_back(entries[i].kernel->id);
  return speed;
}

}  // namespace

Json ladder_json(const LadderPlan& plan, const LadderResult& result,
                 const std::vector<LadderDifferenceData>& differences, const std::string& command) {
  const Entries& entries = result.entries;
  const ExponentWindow scanned = scanned_exponents(plan.precision);
  LadderData data;
  data.command = command;
  data.precision = plan.precision;
  data.seed = {plan.seed};
  data.trials = plan.trials;
  for (const SourcePtr& source : plan.sources) data.families.push_back(source->name());
  data.sweep = sweep_of(plan.sources);
  data.scanned_exponents = {scanned.low, scanned.high};
  for (std::size_t k = 0; k < entries.size(); ++k) data.kernels.push_back(kernel_data(plan, result, k));
  data.differences = differences;
  const std::vector<LadderStep> steps = ladder_steps(plan.kernels);
  for (const LadderStep& step : steps)
    data.steps.push_back({entries[step.from].kernel->id, entries[step.to].kernel->id});
  const auto made = [&](std::optional<std::size_t> i) {
    return i ? std::optional<Name>(entries[steps[*i].to].kernel->id) : std::nullopt;
  };
  for (std::size_t s = 0; s < plan.sources.size(); ++s) {
    NamedValues<CostliestData>& family = data.costliest_steps.put(plan.sources[s]->name());
    for (const AxisKind kind : enumerators<AxisKind>) {
      const CostliestSteps costliest = costliest_steps(entries, steps, kind, s);
      family.put(axis_kind_names[kind]) = {made(costliest.sign_errors), made(costliest.rounding_sign_errors),
                                           made(costliest.worst_error), made(costliest.range)};
    }
  }
  if (plan.speed) data.speed = speed_data(entries);
  return json_of(data);
}

}  // namespace axiscert
