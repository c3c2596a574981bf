#include "fuzz/sphere_triangle/formulae/ladder_steps.h"
#include "reports/instrument/precision/ladder_data.h"
#include "reports/instrument/precision/ladder_report.h"

namespace axiscert {
namespace {

WindowData window_data(const std::optional<ExponentWindow>& window) {
  return window ? WindowData({window->low, window->high}) : WindowData();
}

FiguresData figures_data(const ComparisonAccuracy& accuracy, bool has_sides) {
  FiguresData figures{accuracy, {}, {}, {}, {}, {}, {}, {}};
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

LadderKernelData kernel_data(const LadderPlan& plan, const LadderEntry& entry) {
  const bool has_sides = entry.kernel->exposes == Exposure::sides;
  LadderKernelData kernel{entry.kernel->id, entry.kernel->summary, has_sides, result_data(entry.all, has_sides), {}};
  for (std::size_t i = 0; i < axis_count; ++i) kernel.all.axes[i].window.emplace(window_data(entry.windows[i]));
  for (std::size_t i = 0; i < axis_kind_count; ++i) {
    kernel.all.kinds[i].figures.window.emplace(
        window_data(common_window(entry.windows, axes_of_kind(static_cast<AxisKind>(i)))));
  }
  for (std::size_t s = 0; s < plan.sources.size(); ++s)
    kernel.families.put(plan.sources[s]->name()) = result_data(entry.by_source[s], has_sides);
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

Json ladder_json(const LadderPlan& plan, const std::vector<LadderEntry>& entries, const std::string& command) {
  const ExponentWindow scanned = scanned_exponents(plan.precision);
  LadderData data;
  data.command = command;
  data.precision = plan.precision;
  data.seed = {plan.seed};
  data.trials = plan.trials;
  for (const SourcePtr& source : plan.sources) data.families.push_back(source->name());
  data.scanned_exponents = {scanned.low, scanned.high};
  for (const LadderEntry& entry : entries) data.kernels.push_back(kernel_data(plan, entry));
  const std::vector<LadderStep> steps = ladder_steps(entries);
  for (const LadderStep& step : steps)
    data.steps.push_back({entries[step.from].kernel->id, entries[step.to].kernel->id});
  const auto made = [&](std::optional<std::size_t> i) {
    return i ? std::optional<Name>(entries[steps[*i].to].kernel->id) : std::nullopt;
  };
  for (const AxisKind kind : enumerators<AxisKind>) {
    const CostliestSteps costliest = costliest_steps(entries, steps, kind);
    data.costliest_steps.put(axis_kind_names[kind]) = {made(costliest.sign_errors),
                                                       made(costliest.rounding_sign_errors),
                                                       made(costliest.worst_error), made(costliest.range)};
  }
  if (plan.speed) data.speed = speed_data(entries);
  return json_of(data);
}

}  // namespace axiscert
