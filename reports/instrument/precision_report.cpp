#include "reports/instrument/precision_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/sphere_triangle/degree.h"
#include "fuzz/record/proportions.h"
#include "fuzz/text/json_form.h"
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

double rate_per_million(std::uint64_t count, std::uint64_t queries) {
  return queries == 0 ? 0 : 1e6 * static_cast<double>(count) / static_cast<double>(queries);
}
std::string rate(std::uint64_t count, std::uint64_t queries) {
  return queries == 0 ? "not measured" : amount(rate_per_million(count, queries), 3);
}

int own_digits(const PrecisionPlan& plan) {
  return plan.precision == Precision::binary32 ? std::numeric_limits<float>::digits
                                               : std::numeric_limits<double>::digits;
}
// The formats that tables of one format show: all where they are few, else that of the queries.
std::vector<std::size_t> shown_numbers(const PrecisionPlan& plan, std::size_t few) {
  std::vector<std::size_t> shown;
  for (std::size_t n = 0; n < plan.numbers.size(); ++n) {
    if (plan.numbers.size() <= few || plan.numbers[n].bits == own_digits(plan)) shown.push_back(n);
  }
  return shown;
}

std::vector<std::string> kernel_columns(const PrecisionPlan& plan, std::string first) {
  std::vector<std::string> columns = {std::move(first)};
  for (const Kernel* kernel : plan.kernels) columns.push_back(kernel->id);
  return columns;
}

// The mean over the seeds of a format, per million; of several seeds also the least and the greatest.
template <class Count>
std::string seeds_rate(const PrecisionPlan& plan, const KernelPrecision& kernel, std::size_t number, Count&& count) {
  std::uint64_t found = 0, queries = 0;
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (std::size_t s = 0; s < plan.seeds(); ++s) {
    const PrecisionStep& step = kernel.steps[number * plan.seeds() + s];
    found += count(step);
    queries += step.queries;
    const double of_seed = rate_per_million(count(step), step.queries);
    least = std::min(least, of_seed);
    greatest = std::max(greatest, of_seed);
  }
  if (queries == 0) return "not measured";
  if (plan.seeds() == 1 || least == greatest) return rate(found, queries);
  return fmt::format("{} ({} to {})", rate(found, queries), amount(least, 3), amount(greatest, 3));
}
InstrumentTable verdict_table(const PrecisionPlan& plan, const PrecisionTally& all, ExponentRange range) {
  InstrumentTable table{
      fmt::format("Wrong verdicts per million, {}", exponents_text(plan, range)), kernel_columns(plan, "number"), {}};
  for (std::size_t n = 0; n < plan.numbers.size(); ++n) {
    std::vector<std::string>& row = table.rows.emplace_back(1, plan.numbers[n].name);
    for (const KernelPrecision& k : all.kernels) row.push_back(seeds_rate(plan, k, n, wrong_in(range)));
  }
  std::vector<std::string>& exact = table.rows.emplace_back(1, "exact");
  for (const KernelPrecision& k : all.kernels) exact.push_back(rate(k.exact.total(), all.queries));
  return table;
}

// Verdicts changed by the bits of a format, next to those changed by its exponents.
InstrumentTable separation_table(const PrecisionPlan& plan, const PrecisionTally& all,
                                 const std::vector<std::size_t>& numbers) {
  InstrumentTable table{"Rounding apart from range; per million",
                        {"kernel", "number", "wrong in exact arithmetic", "wrong, unlimited exponents",
                         "wrong, limited exponents", "verdicts changed by rounding", "verdicts changed by range"},
                        {}};
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    for (const std::size_t n : numbers) {
      std::vector<std::string>& row = table.rows.emplace_back(1, plan.kernels[k]->id);
      row.push_back(plan.numbers[n].name);
      const auto add = [&](auto&& count) { row.push_back(seeds_rate(plan, all.kernels[k], n, count)); };
      add([](const PrecisionStep& step) { return step.exact.total(); });
      add(wrong_in(unlimited));
      add(wrong_in(limited));
      add([](const PrecisionStep& step) { return step.rounding; });
      add([](const PrecisionStep& step) { return step.range; });
    }
  }
  return table;
}

InstrumentTable family_table(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies, std::size_t number,
                             ExponentRange range) {
  InstrumentTable table{fmt::format("Wrong verdicts per million at {} by family, {}", plan.numbers[number].name,
                                    exponents_text(plan, range)),
                        kernel_columns(plan, "family"),
                        {}};
  for (std::size_t s = 0; s < tallies.size(); ++s) {
    std::vector<std::string>& row = table.rows.emplace_back(1, plan.sources[s]->name());
    for (const KernelPrecision& k : tallies[s].kernels) row.push_back(seeds_rate(plan, k, number, wrong_in(range)));
  }
  return table;
}

// Queries that a format does not have: rounded to it, a number becomes infinite or NaN.
InstrumentTable left_out_table(const PrecisionPlan& plan, const PrecisionTally& all) {
  InstrumentTable table{"Queries that the format does not have", {"number", "of", "left out"}, {}};
  for (std::size_t n = 0; n < plan.numbers.size(); ++n) {
    const std::uint64_t there = all.kernels.front().steps[n * plan.seeds()].queries;
    table.rows.push_back({plan.numbers[n].name, thousands(all.queries), thousands(all.queries - there)});
  }
  return table;
}

std::string sufficient_text(std::optional<int> bits, const KernelPrecision& kernel) {
  if (bits) return fmt::format("{}", *bits);
  return kernel.steps.back().queries == 0 ? "not measured" : "none";
}
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
                              sufficient_text(sufficient_bits(plan, kernel, kind.comparisons), kernel)});
      }
    }
    const SufficientVerdictBits verdict = sufficient_verdict_bits(plan, kernel);
    table.rows.push_back(
        {id, "verdict, as in exact arithmetic", "", "", "", "", sufficient_text(verdict.own_verdict, kernel)});
    table.rows.push_back({id, "verdict, as the geometry", "", "", "", "", sufficient_text(verdict.verdict, kernel)});
  }
  return table;
}

PrecisionTallyData tally_data(const PrecisionPlan& plan, const PrecisionTally& tally, double size) {
  PrecisionTallyData data{tally.queries, {}, {}, {}};
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    const KernelPrecision& kernel = tally.kernels[k];
    KernelPrecisionData& of = data.kernels.put(plan.kernels[k]->id) = {kernel.exact, {}};
    for (std::size_t i = 0; i < plan.step_count(); ++i) {
      const NumberFormat& number = plan.number_of(i);
      const PrecisionStep& step = kernel.steps[i];
      const auto rate = [&](ExponentRange range) {
        return rate_with_limits(step.in(range).verdict.total(), step.queries, size);
      };
      of.precisions.push_back({number.name, number.bits, plan.seed_of(i), rate(unlimited), rate(limited), step});
    }
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
  for (const NumberFormat& number : plan.numbers) {
    const ExponentLimits exponents = number.exponents.value_or(plan.precision);
    data.numbers.push_back({number.name, number.bits, static_cast<int>(exponents.least),
                            static_cast<int>(exponents.greatest), exponents.overflow});
  }
  data.rounding = plan.rounding;
  if (is_by_chance(plan.rounding)) {
    for (std::uint64_t seed = 1; seed <= plan.seeds(); ++seed) data.rounding_seeds.push_back(seed);
  }
  data.contraction = plan.contraction;
  data.inputs_are_rounded = plan.round_inputs;
  data.sweep = sweep_of(plan.sources);
  for (std::size_t k = 0; k < plan.kernels.size(); ++k)
    data.sufficient.put(plan.kernels[k]->id) = sufficient_data(plan, *plan.kernels[k], all.kernels[k]);
  data.all = tally_data(plan, all, cluster_size(plan, tallies));
  for (std::size_t s = 0; s < tallies.size(); ++s) {
    const Source& source = *plan.sources[s];
    PrecisionTallyData& family = data.families.put(source.name()) = tally_data(plan, tallies[s], cluster_size(plan, s));
    family.swept = swept_value(source);
    if (swept_point(source) != nullptr && swept_point(source)->parameter == SweepParameter::offset)
      family.scene_size = median_scene_size(unswept(source), plan.seed, plan.precision);
  }
  return json_of(data);
}

std::string rounding_text(const PrecisionPlan& plan) {
  switch (plan.rounding) {
    case RoundingRule::nearest:
      return "to nearest even";
    case RoundingRule::up:
      return "toward +infinity";
    case RoundingRule::down:
      return "toward -infinity";
    case RoundingRule::zero:
      return "toward zero";
    case RoundingRule::faithful:
      return fmt::format("to either neighbour by a coin (seeds 1 to {}: the mean, and the least and greatest of them)",
                         plan.seeds());
    case RoundingRule::stochastic:
      return fmt::format(
          "to either neighbour, with a probability proportional to the distance of the other (seeds 1 "
          "to {}: the mean, and the least and greatest of them)",
          plan.seeds());
  }
  return "";
}

// The fewest that a format has which has any; 0: none has.
std::uint64_t fewest_queries(const PrecisionTally& all) {
  std::uint64_t fewest = 0;
  for (const PrecisionStep& step : all.kernels.front().steps) {
    if (step.queries != 0) fewest = fewest == 0 ? step.queries : std::min(fewest, step.queries);
  }
  return fewest;
}

std::vector<std::string> notes(const PrecisionPlan& plan, const PrecisionTally& all) {
  std::string families;
  for (const SourcePtr& source : plan.sources) families += (families.empty() ? "" : ", ") + source->name();
  const std::uint64_t fewest = fewest_queries(all);
  const bool is_checked = plan.rounding == RoundingRule::nearest;
  return {
      fmt::format("{} valid {} queries: {}. {} Every operation of the formulae is rounded {} in the format (MPFR). "
                  "Kernels by their formulae: arithmetic is scalar and plain, and {}.",
                  thousands(all.queries), name(plan.precision), families,
                  plan.round_inputs
                      ? "The numbers of a query are rounded to the format first, to nearest even: truth and exact "
                        "signs are those of the rounded query, so that the format's error on its own inputs is shown."
                      : "Queries are taken as they are, whatever the format: what the operations alone cost is shown.",
                  rounding_text(plan),
                  plan.contraction == Contraction::dots ? "dot and cross products are fused, as in `+fma`"
                                                        : "nothing is fused"),
      fmt::format("Unlimited exponents: errors come from rounding or from the formulae. Limited ones are those of the "
                  "format, of bits=P those of {}, with gradual underflow. {}",
                  name(plan.precision),
                  is_checked ? fmt::format("{} bits with these are the scalar reference itself, which is checked on "
                                           "every query.",
                                           own_digits(plan))
                             : ""),
      "A wrong verdict is one that differs from the geometry; the row `exact` has those of the formulae in exact "
      "arithmetic, which no number of bits mends. Rungs of one strictness agree there on every query: that is checked "
      "as well. With strict sides the count can rise with the bits: noise breaks the ties that the formulae answer "
      "wrongly. A flip of a comparison is a difference from the kernel's own exact sign.",
      "Degree: all coordinates and the radius times s multiply a side by s to that power. Bits for integers: enough to "
      "evaluate the comparison without a rounding where coordinates and radius are integers of b bits, sign apart; "
      "none where a form divides or takes a root. Floats whose exponents differ need more. Least bits seen: of those "
      "listed, over these queries; nothing is proved by it.",
      "Figures of all families together have each query with the same weight; those by family stand below.",
      "Error bars, and in the JSON and CSV `low` and `high`: Wilson's limits of a rate, 95 %. Queries of one triangle "
      "or image group, the comparisons of a query and its seeds count as one.",
      fewest == 0
          ? std::string("No format has any of these queries: nothing was measured.")
          : fmt::format(
                "0 among {} of these queries means less than {} per million of them, 95 %, for these generators "
                "only.",
                thousands(fewest), amount(1e6 * excluded_rate(fewest), 3))};
}

}  // namespace

InstrumentReport precision_report(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies,
                                  const std::string& command) {
  const PrecisionTally all = total(tallies);
  const bool is_of_nothing = fewest_queries(all) == 0;
  InstrumentReport report{"precision",
                          fmt::format("{}What precision costs, {} queries",
                                      is_of_nothing ? "Nothing was measured. " : "", name(plan.precision)),
                          command,
                          notes(plan, all),
                          {verdict_table(plan, all, unlimited), verdict_table(plan, all, limited)},
                          precision_plots(plan, tallies, all),
                          precision_json(plan, tallies, all, command)};
  report.is_of_nothing = is_of_nothing;
  if (plan.round_inputs) report.tables.push_back(left_out_table(plan, all));
  const std::vector<std::size_t> apart = shown_numbers(plan, 12);
  if (!apart.empty()) report.tables.push_back(separation_table(plan, all, apart));
  for (const std::size_t number : shown_numbers(plan, 4)) {
    report.tables.push_back(family_table(plan, tallies, number, unlimited));
    report.tables.push_back(family_table(plan, tallies, number, limited));
  }
  report.tables.push_back(sufficient_table(plan, all));
  return report;
}

}  // namespace axiscert
