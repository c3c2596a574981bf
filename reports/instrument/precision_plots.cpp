// Rates of `axiscert precision` with their limits, and its plots.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fuzz/record/proportions.h"
#include "fuzz/sphere_triangle/formulae/choices.h"
#include "reports/instrument/precision_report.h"

namespace axiscert {

std::string exponents_text(const PrecisionPlan& plan, ExponentRange range) {
  if (range == ExponentRange::unlimited) return "unlimited exponents";
  const bool are_of_queries =
      std::ranges::all_of(plan.numbers, [](const NumberFormat& number) { return !number.exponents; });
  return are_of_queries ? fmt::format("exponents of {}", name(plan.precision)) : "exponents of the format";
}

double cluster_size(const PrecisionPlan& plan, std::size_t source) {
  const Source& of = *plan.sources[source];
  const std::uint64_t trials = of.fixed_size(plan.precision).value_or(plan.trials);
  const std::uint64_t clusters = of.base_triangles(plan.precision, trials);
  return clusters == 0 ? 1 : std::max(1.0, static_cast<double>(trials) / static_cast<double>(clusters));
}
double cluster_size(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies) {
  double queries = 0, clusters = 0;
  for (std::size_t s = 0; s < tallies.size(); ++s) {
    queries += static_cast<double>(tallies[s].queries);
    clusters += static_cast<double>(tallies[s].queries) / cluster_size(plan, s);
  }
  return clusters == 0 ? 1 : queries / clusters;
}

std::optional<WrongRateData> rate_with_limits(std::uint64_t failures, std::uint64_t trials, double size) {
  if (trials == 0) return std::nullopt;
  const auto clusters = static_cast<std::uint64_t>(std::ceil(static_cast<double>(trials) / size));
  const auto together = static_cast<std::uint64_t>(std::llround(size));
  ClusterSums sums;
  for (std::uint64_t left = failures; left > 0;) {
    const std::uint64_t fails = std::min(left, together);
    sums.add(static_cast<std::int64_t>(fails));
    left -= fails;
  }
  const auto limits = wilson_limits({trials, clusters}, sums);
  if (!limits) return std::nullopt;
  return WrongRateData{static_cast<double>(failures) / static_cast<double>(trials), limits->low, limits->high};
}

namespace {

using enum ExponentRange;

// What `count` counts in a format, over its seeds, with limits: the seeds of a query and what else is counted of it, of
// which `each` are in a query, are one trial.
template <class Count>
std::optional<WrongRateData> mean_rate(const PrecisionPlan& plan, const KernelPrecision& kernel, std::size_t number,
                                       double size, const Count& count, std::uint64_t each = 1) {
  std::uint64_t found = 0, queries = 0;
  for (std::size_t s = 0; s < plan.seeds(); ++s) {
    const PrecisionStep& step = kernel.steps[number * plan.seeds() + s];
    found += count(step);
    queries += step.queries;
  }
  return rate_with_limits(found, queries * each, size * static_cast<double>(plan.seeds() * each));
}

// Adds a point per million with its error bar, where the rate is above 0.
void add_point(InstrumentSeries& series, double x, const std::optional<WrongRateData>& rate, std::string label) {
  if (!rate || rate->rate <= 0) return;
  series.points.emplace_back(x, 1e6 * rate->rate);
  series.intervals.emplace_back(1e6 * rate->low, 1e6 * rate->high);
  series.labels.push_back(std::move(label));
}

template <class Count>
InstrumentPlot plot(const PrecisionPlan& plan, const PrecisionTally& all, double size, std::string caption,
                    std::string y_label, Count&& count) {
  InstrumentPlot plot{std::move(caption), "bits", std::move(y_label), InstrumentPlot::Kind::line, false, true, {}};
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    InstrumentSeries series{plan.kernels[k]->id, {}, {}};
    for (std::size_t n = 0; n < plan.numbers.size(); ++n)
      add_point(series, plan.numbers[n].bits, mean_rate(plan, all.kernels[k], n, size, count), plan.numbers[n].name);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

constexpr std::uint64_t edge_comparisons = 6;

std::uint64_t edge_flips(const PrecisionStep& step) {
  std::uint64_t sum = 0;
  for_each_bit(comparisons_of_kind(AxisKind::edge), [&](std::size_t i) { sum += step.unlimited.comparisons[i]; });
  return sum;
}
// Sign errors of the edge comparisons, which alone have forms that are not centred.
std::optional<WrongRateData> sign_errors(const PrecisionPlan& plan, const PrecisionTally& tally, std::size_t kernel,
                                         std::size_t number, double size) {
  return mean_rate(plan, tally.kernels[kernel], number, size, edge_flips, edge_comparisons);
}

struct KernelNumber {
  std::size_t kernel, number;
};
std::vector<KernelNumber> kernel_numbers(const PrecisionPlan& plan) {
  std::vector<KernelNumber> all;
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    for (std::size_t n = 0; n < plan.numbers.size(); ++n) all.push_back({k, n});
  }
  return all;
}

// Sign errors against offset x u / size, where the offset is swept: that puts the formats on one axis; u = 2^-bits.
std::optional<InstrumentPlot> relative_plot(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies) {
  const auto sweep = sweep_of(plan.sources);
  if (!sweep || sweep->parameter != SweepParameter::offset) return std::nullopt;
  InstrumentPlot plot{"Sign errors of edge comparisons, unlimited exponents, against the offset in units of the format",
                      "offset x 2^-bits / size of the scene",
                      "per million edge comparisons",
                      InstrumentPlot::Kind::scatter,
                      true,
                      true,
                      {}};
  std::vector<double> sizes;  // by source
  for (const SourcePtr& source : plan.sources)
    sizes.push_back(median_scene_size(unswept(*source), plan.seed, plan.precision));
  for (const auto& [k, n] : kernel_numbers(plan)) {
    InstrumentSeries series{fmt::format("{}, {}", plan.kernels[k]->id, plan.numbers[n].name), {}, {}};
    for (std::size_t s = 0; s < plan.sources.size(); ++s) {
      const auto offset = swept_value(*plan.sources[s]);
      if (!offset || offset->value <= 0 || sizes[s] <= 0) continue;
      add_point(series, std::ldexp(offset->value, -plan.numbers[n].bits) / sizes[s],
                sign_errors(plan, tallies[s], k, n, cluster_size(plan, s)), plan.sources[s]->name());
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

std::optional<SweepY> y_of(const std::optional<WrongRateData>& rate) {
  if (!rate) return std::nullopt;
  return SweepY{1e6 * rate->rate, std::pair(1e6 * rate->low, 1e6 * rate->high)};
}

void add_sweep_plots(std::vector<InstrumentPlot>& plots, const PrecisionPlan& plan,
                     const std::vector<PrecisionTally>& tallies) {
  const std::vector<KernelNumber> lines = kernel_numbers(plan);
  std::vector<std::string> names;
  for (const auto& [k, n] : lines) names.push_back(fmt::format("{}, {}", plan.kernels[k]->id, plan.numbers[n].name));
  const auto wrong = [&](std::size_t line, std::size_t s) {
    const auto [k, n] = lines[line];
    return y_of(mean_rate(plan, tallies[s].kernels[k], n, cluster_size(plan, s), wrong_in(unlimited)));
  };
  const auto signs = [&](std::size_t line, std::size_t s) {
    const auto [k, n] = lines[line];
    return y_of(sign_errors(plan, tallies[s], k, n, cluster_size(plan, s)));
  };
  if (auto of_verdicts =
          sweep_plot(plan.sources, "Wrong verdicts over the swept parameter, unlimited exponents; none has no point",
                     "per million", names, wrong))
    plots.push_back(*of_verdicts);
  if (auto of_signs =
          sweep_plot(plan.sources, "Sign errors of edge comparisons over the swept parameter, unlimited exponents",
                     "per million edge comparisons", names, signs))
    plots.push_back(*of_signs);
  if (auto relative = relative_plot(plan, tallies)) plots.push_back(*relative);
}

}  // namespace

std::vector<InstrumentPlot> precision_plots(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies,
                                            const PrecisionTally& all) {
  std::vector<InstrumentPlot> all_plots;
  const double size = cluster_size(plan, tallies);
  add_sweep_plots(all_plots, plan, tallies);
  for (const ExponentRange range : {unlimited, limited}) {
    all_plots.push_back(
        plot(plan, all, size,
             fmt::format("Wrong verdicts, {}; a kernel without any has no point", exponents_text(plan, range)),
             "per million", wrong_in(range)));
  }
  all_plots.push_back(plot(plan, all, size, "Verdicts that rounding changes, unlimited exponents", "per million",
                           [](const PrecisionStep& step) { return step.rounding; }));
  all_plots.push_back(plot(plan, all, size * edge_comparisons,
                           "Flips of the six edge comparisons together, unlimited exponents", "per million queries",
                           edge_flips));
  return all_plots;
}

}  // namespace axiscert
