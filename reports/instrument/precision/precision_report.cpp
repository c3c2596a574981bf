#include "reports/instrument/precision/precision_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/sphere_triangle/unbounded/degree.h"
#include "kernel/formulae_list.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

using enum ExponentRange;

// Comparisons that the formulae treat alike share a row.
struct Kind {
  std::string_view name;
  ComparisonBits comparisons;
};
const std::array<Kind, 5>& kinds() {
  static const std::array<Kind, 5> all = [] {
    std::array<Kind, 5> k = {{{comparisons[Comparison::plane_radius].name, 0},
                              {"vertex radius", 0},
                              {"vertex sides", 0},
                              {"edge radius", 0},
                              {"edge sides", 0}}};
    for (std::size_t i = 0; i < comparison_count; ++i) {
      const bool at_plane = comparisons[i].axis == Axis::plane, at_edge = comparisons[i].axis >= Axis::edge_ab;
      const std::size_t kind = at_plane ? 0 : (at_edge ? 3 : 1) + (comparisons[i].is_radius ? 0 : 1);
      k[kind].comparisons |= one_bit<ComparisonBits>(i);
    }
    return k;
  }();
  return all;
}
constexpr std::size_t edge_radius_kind = 3, edge_sides_kind = 4;

double rate_per_million(std::uint64_t count, std::uint64_t queries) {
  return queries == 0 ? 0 : 1e6 * static_cast<double>(count) / static_cast<double>(queries);
}
std::string rate(std::uint64_t count, std::uint64_t queries) { return amount(rate_per_million(count, queries), 3); }

std::uint64_t flips(const PrecisionCounts& counts, ComparisonBits which) {
  std::uint64_t sum = 0;
  for_each_bit(which, [&](std::size_t i) { sum += counts.comparisons[i]; });
  return sum;
}

std::string exponents_text(const PrecisionPlan& plan, ExponentRange range) {
  return range == unlimited ? "unlimited exponents" : fmt::format("exponents of {}", name(plan.precision));
}
int own_digits(const PrecisionPlan& plan) {
  return plan.precision == Precision::binary32 ? std::numeric_limits<float>::digits
                                               : std::numeric_limits<double>::digits;
}

std::vector<std::string> kernel_columns(const PrecisionPlan& plan, std::string first) {
  std::vector<std::string> columns = {std::move(first)};
  for (const Kernel* kernel : plan.kernels) columns.push_back(kernel->id);
  return columns;
}

InstrumentTable verdict_table(const PrecisionPlan& plan, const PrecisionTally& all, ExponentRange range) {
  InstrumentTable table{
      fmt::format("Wrong verdicts per million, {}", exponents_text(plan, range)), kernel_columns(plan, "bits"), {}};
  for (std::size_t i = 0; i < plan.bits.size(); ++i) {
    std::vector<std::string>& row = table.rows.emplace_back(1, fmt::format("{}", plan.bits[i]));
    for (const KernelPrecision& k : all.kernels) row.push_back(rate(k.steps[i].in(range).verdict.total(), all.queries));
  }
  std::vector<std::string>& exact = table.rows.emplace_back(1, "exact");
  for (const KernelPrecision& k : all.kernels) exact.push_back(rate(k.exact.total(), all.queries));
  return table;
}

// Verdicts changed by the precision's own number of bits, next to those changed by its exponents. `step` is the
// position of that number of bits in the plan.
InstrumentTable separation_table(const PrecisionPlan& plan, const PrecisionTally& all, std::size_t step) {
  InstrumentTable table{fmt::format("Rounding apart from range, at the {} bits of {}; per million", plan.bits[step],
                                    name(plan.precision)),
                        {"kernel", "wrong in exact arithmetic", "wrong, unlimited exponents",
                         "wrong, limited exponents", "verdicts changed by rounding", "verdicts changed by range"},
                        {}};
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    const KernelPrecision& kernel = all.kernels[k];
    const PrecisionStep& s = kernel.steps[step];
    std::vector<std::string>& row = table.rows.emplace_back(1, plan.kernels[k]->id);
    for (const std::uint64_t count :
         {kernel.exact.total(), s.in(unlimited).verdict.total(), s.in(limited).verdict.total(), s.rounding, s.range}) {
      row.push_back(rate(count, all.queries));
    }
  }
  return table;
}

InstrumentTable family_table(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies, std::size_t step,
                             ExponentRange range) {
  InstrumentTable table{
      fmt::format("Wrong verdicts per million at {} bits by family, {}", plan.bits[step], exponents_text(plan, range)),
      kernel_columns(plan, "family"),
      {}};
  for (std::size_t s = 0; s < tallies.size(); ++s) {
    std::vector<std::string>& row = table.rows.emplace_back(1, plan.sources[s]->name());
    for (const KernelPrecision& k : tallies[s].kernels) {
      row.push_back(rate(k.steps[step].in(range).verdict.total(), tallies[s].queries));
    }
  }
  return table;
}

std::string sufficient_text(std::optional<int> bits) { return bits ? fmt::format("{}", *bits) : "none"; }
std::string degree_text(std::optional<double> degree) { return degree ? fmt::format("{}", *degree) : "zero"; }

InstrumentTable sufficient_table(const PrecisionPlan& plan, const PrecisionTally& all) {
  const int b = own_digits(plan);
  InstrumentTable table{"Least bits from which on nothing flips, unlimited exponents",
                        {"kernel", "comparisons", "degree, left", "degree, right", "bits for integers of b bits",
                         fmt::format("at b = {}", b), "least bits seen"},
                        {}};
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    const KernelPrecision& kernel = all.kernels[k];
    const std::string& id = plan.kernels[k]->id;
    if (const auto degrees = degrees_of(formulae_of(*plan.kernels[k]))) {
      for (const Kind& kind : kinds()) {
        const std::size_t first = first_bit(kind.comparisons);
        const ComparisonDegree& d = (*degrees)[first];
        table.rows.push_back({id, std::string(kind.name), degree_text(d.lhs), degree_text(d.rhs),
                              d.bits ? fmt::format("{} b + {}", d.bits->per_bit, d.bits->constant) : "none",
                              d.bits ? fmt::format("{}", d.bits->at(b)) : "none",
                              sufficient_text(sufficient_bits(plan, kernel, kind.comparisons))});
      }
    }
    const SufficientVerdictBits verdict = sufficient_verdict_bits(plan, kernel);
    table.rows.push_back({id, "verdict, as in exact arithmetic", "", "", "", "", sufficient_text(verdict.own_verdict)});
    table.rows.push_back({id, "verdict, as the geometry", "", "", "", "", sufficient_text(verdict.verdict)});
  }
  return table;
}

template <class Count>
InstrumentPlot plot(const PrecisionPlan& plan, const PrecisionTally& all, std::string caption, std::string y_label,
                    Count&& count) {
  InstrumentPlot plot{std::move(caption), "bits", std::move(y_label), InstrumentPlot::Kind::line, false, true, {}};
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    InstrumentSeries series{plan.kernels[k]->id, {}, {}};
    for (std::size_t i = 0; i < plan.bits.size(); ++i) {
      const std::uint64_t found = count(all.kernels[k].steps[i]);
      if (found > 0) series.points.emplace_back(plan.bits[i], rate_per_million(found, all.queries));
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

std::vector<InstrumentPlot> plots(const PrecisionPlan& plan, const PrecisionTally& all) {
  std::vector<InstrumentPlot> all_plots;
  for (const ExponentRange range : {unlimited, limited}) {
    all_plots.push_back(plot(
        plan, all, fmt::format("Wrong verdicts, {}; a kernel without any has no point", exponents_text(plan, range)),
        "per million", [range](const PrecisionStep& step) { return step.in(range).verdict.total(); }));
  }
  all_plots.push_back(plot(plan, all, "Verdicts that rounding changes, unlimited exponents", "per million",
                           [](const PrecisionStep& step) { return step.rounding; }));
  const auto edges =
      static_cast<ComparisonBits>(kinds()[edge_radius_kind].comparisons | kinds()[edge_sides_kind].comparisons);
  all_plots.push_back(plot(plan, all, "Flips of the six edge comparisons together, unlimited exponents",
                           "per million queries",
                           [edges](const PrecisionStep& step) { return flips(step.in(unlimited), edges); }));
  return all_plots;
}

PrecisionTallyData tally_data(const PrecisionPlan& plan, const PrecisionTally& tally) {
  PrecisionTallyData data{tally.queries, {}};
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    const KernelPrecision& kernel = tally.kernels[k];
    KernelPrecisionData& of = data.kernels.put(plan.kernels[k]->id) = {kernel.exact, {}};
    for (std::size_t i = 0; i < plan.bits.size(); ++i) of.precisions.push_back({plan.bits[i], kernel.steps[i]});
  }
  return data;
}

SufficientData sufficient_data(const PrecisionPlan& plan, const Kernel& kernel, const KernelPrecision& found) {
  SufficientData data{sufficient_verdict_bits(plan, found), {}};
  const auto degrees = degrees_of(formulae_of(kernel));
  if (!degrees) return data;
  data.comparisons.emplace();
  for (std::size_t i = 0; i < comparison_count; ++i) {
    const ComparisonDegree& d = (*degrees)[i];
    data.comparisons->put(comparisons[i].name) = {
        d.lhs, d.rhs, d.bits ? std::optional(IntegerBitsData{d.bits->per_bit, d.bits->constant}) : std::nullopt,
        sufficient_bits(plan, found, one_bit<ComparisonBits>(i))};
  }
  return data;
}

Json precision_json(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies, const PrecisionTally& all,
                    const std::string& command) {
  PrecisionData data;
  data.command = command;
  data.precision = plan.precision;
  data.trials = plan.trials;
  data.seed = {plan.seed};
  data.bits = plan.bits;
  for (std::size_t k = 0; k < plan.kernels.size(); ++k)
    data.sufficient.put(plan.kernels[k]->id) = sufficient_data(plan, *plan.kernels[k], all.kernels[k]);
  data.all = tally_data(plan, all);
  for (std::size_t s = 0; s < tallies.size(); ++s)
    data.families.put(plan.sources[s]->name()) = tally_data(plan, tallies[s]);
  return json_of(data);
}

std::vector<std::string> notes(const PrecisionPlan& plan, const PrecisionTally& all) {
  std::string families;
  for (const SourcePtr& source : plan.sources) families += (families.empty() ? "" : ", ") + source->name();
  const double limit = all.queries == 0 ? 1e6 : 1e6 * -std::expm1(std::log(0.05) / static_cast<double>(all.queries));
  return {
      fmt::format("{} valid {} queries, as many of each family: {}. Queries are taken as they are; every operation of "
                  "the formulae is rounded to nearest even at the number of bits (MPFR). Kernels by their formulae: "
                  "arithmetic is scalar and plain, and nothing is fused.",
                  thousands(all.queries), name(plan.precision), families),
      fmt::format("Unlimited exponents: errors come from rounding or from the formulae. Exponents of {}: with "
                  "gradual underflow at that number of bits, so that {} bits are the scalar reference itself, which is "
                  "checked on every query.",
                  name(plan.precision), own_digits(plan)),
      "A wrong verdict is one that differs from the geometry; the row `exact` has those of the formulae in exact "
      "arithmetic, which no number of bits mends. Rungs of one strictness agree there on every query: that is checked "
      "as well. With strict sides the count can rise with the bits: noise breaks the ties that the formulae answer "
      "wrongly. A flip of a comparison is a difference from the kernel's own exact sign.",
      "Degree: all coordinates and the radius times s multiply a side by s to that power. Bits for integers: enough to "
      "evaluate the comparison without a rounding where coordinates and radius are integers of b bits, sign apart; "
      "none "
      "where a form divides or takes a root. Floats whose exponents differ need more. Least bits seen: of those "
      "listed, "
      "over these queries; nothing is proved by it.",
      fmt::format("0 among these queries means less than {} per million of them, 95 %, for these generators only.",
                  amount(limit, 3))};
}

}  // namespace

InstrumentReport precision_report(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies,
                                  const std::string& command) {
  const PrecisionTally all = total(tallies);
  InstrumentReport report{"precision",
                          fmt::format("What precision costs, {} queries", name(plan.precision)),
                          command,
                          notes(plan, all),
                          {verdict_table(plan, all, unlimited), verdict_table(plan, all, limited)},
                          plots(plan, all),
                          precision_json(plan, tallies, all, command)};
  const auto own = std::find(plan.bits.begin(), plan.bits.end(), own_digits(plan));
  if (own != plan.bits.end()) {
    const auto step = static_cast<std::size_t>(own - plan.bits.begin());
    report.tables.push_back(separation_table(plan, all, step));
    report.tables.push_back(family_table(plan, tallies, step, unlimited));
    report.tables.push_back(family_table(plan, tallies, step, limited));
  }
  report.tables.push_back(sufficient_table(plan, all));
  return report;
}

}  // namespace axiscert
