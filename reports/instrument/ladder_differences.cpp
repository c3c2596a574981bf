// What the report of `axiscert ladder` says of forms against each other: tests, limits and the least effects.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/instrument/ladder_report.h"

namespace axiscert {
namespace {

constexpr double table_level = 0.05;

std::string million_text(const std::optional<double>& share) {
  return share ? fmt::format("{:.0f}", 1e6 * *share) : std::string();
}
std::string signed_million_text(const std::optional<SignedNumber>& share) {
  return share ? fmt::format("{:+.0f}", 1e6 * share->value) : std::string();
}
std::string probability(const std::optional<double>& p) {
  if (!p) return "";
  return *p < 1e-12 ? "<1e-12" : fmt::format("{:.2g}", *p);
}
std::string difference_limits(const std::optional<SignedNumber>& low, const std::optional<SignedNumber>& high) {
  return low && high ? signed_million_text(low) + " to " + signed_million_text(high) : std::string();
}

bool is_significant(const LadderDifferenceData& difference) {
  return difference.holm_p && *difference.holm_p <= table_level;
}

LadderDifferenceData difference_of(const LadderPlan& plan, const LadderResult& result, std::size_t source,
                                   std::size_t c, Figure figure) {
  const Contrast& contrast = result.contrasts[c];
  const SourceContrasts& counts = result.by_source[source];
  const PairedCounts paired = counts.paired(c, contrast.pairs.size(), figure);
  LadderDifferenceData data;
  data.kind = Name(std::string(name(contrast.kind)));
  const auto id = [&](std::size_t k) { return Name(result.entries[k].kernel->id); };
  data.from = id(contrast.pairs[0].from);
  data.to = id(contrast.pairs[0].to);
  if (contrast.factor) data.factor = Name(std::string(factor_words[*contrast.factor].name));
  if (contrast.kind == ContrastKind::effect) {
    data.from = Name(std::string(factor_words[*contrast.factor].from));
    data.to = Name(std::string(factor_words[*contrast.factor].to));
  }
  data.family = Name(plan.sources[source]->name());
  data.figure = Name(std::string(figure_names[figure]));
  data.pairs = contrast.pairs.size();
  data.trials = paired.of.trials;
  data.clusters = paired.of.clusters;
  for (const LadderStep& pair : contrast.pairs) {
    data.failures_from += static_cast<std::uint64_t>(counts.form(pair.from, figure).total());
    data.failures_to += static_cast<std::uint64_t>(counts.form(pair.to, figure).total());
  }
  data.only_from = paired.only_from;
  data.only_to = paired.only_to;
  const auto difference = rate_difference(paired);
  if (!difference) return data;
  data.difference = SignedNumber{difference->value};
  if (difference->limits) {
    data.low = SignedNumber{difference->limits->low};
    data.high = SignedNumber{difference->limits->high};
  }
  data.design_effect = difference->design_effect;
  const Probability p = sign_flip_two_sided(paired.sums);
  data.p = p.value;
  data.p_is_bound = p.is_bound;
  data.mcnemar_p = mcnemar_two_sided(paired.only_from, paired.only_to).value;
  return data;
}

}  // namespace

LadderRateData ladder_rate(const LadderResult& result, std::size_t source, std::size_t kernel, Figure figure) {
  const ClusteredTrials trials = result.by_source[source].trials(figure);
  const ClusterSums failures = result.by_source[source].form(kernel, figure);
  LadderRateData data{static_cast<std::uint64_t>(failures.total()), trials.trials, trials.clusters, {}, {}, {}};
  if (const auto limits = wilson_limits(trials, failures)) {
    data.rate = static_cast<double>(data.failures) / static_cast<double>(data.trials);
    data.low = limits->low;
    data.high = limits->high;
  }
  return data;
}

std::vector<LadderDifferenceData> ladder_differences(const LadderPlan& plan, const LadderResult& result) {
  std::vector<LadderDifferenceData> all;
  for (const ContrastKind kind : enumerators<ContrastKind>) {
    struct Place {
      std::size_t source, contrast;
      Figure figure;
    };
    std::vector<Place> places;
    for (std::size_t s = 0; s < plan.sources.size(); ++s) {
      for (std::size_t c = 0; c < result.contrasts.size(); ++c) {
        if (result.contrasts[c].kind != kind) continue;
        for (const Figure figure : enumerators<Figure>) {
          if (result.contrasts[c].counts[figure]) places.push_back({s, c, figure});
        }
      }
    }
    std::vector<LadderDifferenceData> own;
    std::vector<double> p;
    const double level = table_level / static_cast<double>(std::max<std::size_t>(1, places.size()));
    for (const auto& [source, contrast, figure] : places) {
      LadderDifferenceData& data = own.emplace_back(difference_of(plan, result, source, contrast, figure));
      data.least = least_difference(
          result.by_source[source].paired(contrast, result.contrasts[contrast].pairs.size(), figure), level);
      p.push_back(data.p.value_or(1));
    }
    const std::vector<double> corrected = holm(p);
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (own[i].p) own[i].holm_p = corrected[i];
    }
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

namespace {

std::vector<std::string> difference_row(const LadderDifferenceData& of) {
  return {of.family,
          of.factor ? *of.factor : "",
          of.from,
          of.to,
          of.figure,
          fmt::format("{}", of.failures_from),
          fmt::format("{}", of.failures_to),
          fmt::format("{}", of.only_from),
          fmt::format("{}", of.only_to),
          signed_million_text(of.difference),
          difference_limits(of.low, of.high),
          probability(of.p) + (of.p_is_bound ? " at most" : ""),
          probability(of.holm_p),
          million_text(of.least)};
}

InstrumentTable difference_table(std::string caption) {
  return {std::move(caption),
          {"family", "factor", "from", "to", "what", "before", "after", "only before", "only after", "per million",
           "95 %", "p", "Holm's p", "least"},
          {}};
}

// How many differences are significant, by family and figure, and the least that each could have shown.
InstrumentTable shown_table(const std::string& caption, const std::vector<const LadderDifferenceData*>& all) {
  InstrumentTable table{
      caption, {"family", "what", "clusters", "differences", "significant", "least per million, from", "to"}, {}};
  std::vector<std::pair<std::string, std::string>> places;
  for (const LadderDifferenceData* one : all) {
    const std::pair<std::string, std::string> place(one->family, one->figure);
    if (std::ranges::find(places, place) == places.end()) places.push_back(place);
  }
  for (const auto& [family, figure] : places) {
    std::uint64_t count = 0, significant = 0, clusters = 0;
    std::optional<double> low, high;
    for (const LadderDifferenceData* one : all) {
      if (one->family != family || one->figure != figure) continue;
      ++count;
      significant += is_significant(*one);
      clusters = one->clusters;
      if (!one->least) continue;
      low = std::min(low.value_or(1), *one->least);
      high = std::max(high.value_or(0), *one->least);
    }
    table.rows.push_back({family, figure, fmt::format("{}", clusters), fmt::format("{}", count),
                          fmt::format("{}", significant), million_text(low), million_text(high)});
  }
  return table;
}

InstrumentTable cells_table(const LadderPlan& plan, const LadderResult& result) {
  constexpr Figure figures[] = {Figure::missed, Figure::phantom, Figure::edge_signs};
  InstrumentTable table{
      "Cells, by family: plane and vertices as published, the edges by four choices; the article's path",
      {"family", "kernel", "frame", "division", "root", "degree", "path"},
      {}};
  for (const Figure figure : figures) table.columns.emplace_back(figure_names[figure]);
  for (std::size_t s = 0; s < plan.sources.size(); ++s) {
    for (std::size_t k = 0; k < result.entries.size(); ++k) {
      const FactorialCell* cell = factorial_cell(*result.entries[k].kernel);
      if (!cell || cell >= factorial_cells().data() + edge_cell_count) continue;
      auto& row =
          table.rows.emplace_back(std::vector<std::string>{plan.sources[s]->name(), result.entries[k].kernel->id});
      for (const Factor factor : {Factor::frame, Factor::division, Factor::root, Factor::degree}) {
        const FactorWords& words = factor_words[factor];
        row.emplace_back(cell->has(factor) ? words.to : words.from);
      }
      using enum Formulae;
      constexpr std::pair<Formulae, const char*> path[] = {{ladder_4, "1"},
                                                           {ladder_5, "2: root"},
                                                           {ladder_7, "3: division"},
                                                           {ladder_8, "4: frame"},
                                                           {reduced, "degree"}};
      const auto found = std::ranges::find(path, cell->formulae, &std::pair<Formulae, const char*>::first);
      row.emplace_back(found == std::end(path) ? "" : found->second);
      for (const Figure figure : figures) row.push_back(fmt::format("{}", result.by_source[s].form(k, figure).total()));
    }
  }
  return table;
}

std::vector<const LadderDifferenceData*> of_kind(const std::vector<LadderDifferenceData>& differences,
                                                 ContrastKind kind) {
  std::vector<const LadderDifferenceData*> found;
  for (const LadderDifferenceData& one : differences) {
    if (one.kind == name(kind)) found.push_back(&one);
  }
  return found;
}

}  // namespace

void add_difference_tables(InstrumentReport& report, const LadderPlan& plan, const LadderResult& result,
                           const std::vector<LadderDifferenceData>& differences) {
  if (InstrumentTable cells = cells_table(plan, result); cells.rows.size() > 1) report.tables.push_back(cells);
  if (const auto effects = of_kind(differences, ContrastKind::effect); !effects.empty()) {
    InstrumentTable table = difference_table(
        "Main effects: all pairs of forms that differ in a factor alone, per million of their queries or comparisons");
    for (const LadderDifferenceData* effect : effects) table.rows.push_back(difference_row(*effect));
    report.tables.push_back(std::move(table));
  }
  for (const auto& [kind, words] : {std::pair(ContrastKind::step, "Steps"), {ContrastKind::pair, "Pairs"}}) {
    const auto all = of_kind(differences, kind);
    if (all.empty()) continue;
    InstrumentTable table = difference_table("");
    for (const LadderDifferenceData* one : all) {
      if (is_significant(*one)) table.rows.push_back(difference_row(*one));
    }
    table.caption =
        fmt::format("{}: the {} of {} differences with Holm's p of at most 5 %, per million; the data have all", words,
                    table.rows.size(), all.size());
    report.tables.push_back(std::move(table));
    report.tables.push_back(shown_table(fmt::format("{}: what these queries can show", words), all));
  }
  if (differences.empty()) return;
  report.notes.push_back(
      "A difference is of the same queries: only before and only after are what one form gets wrong and the other "
      "right. p is of the exact sign-flip test over clusters, two-sided, which is McNemar's exact test where each "
      "cluster is one trial. Clusters are queries, or the image groups or triangles that queries share, and the "
      "comparisons of a query belong together. Limits are Tango's score limits, 95 %, of counts divided by the design "
      "effect. Holm's p is corrected for all differences of steps, of pairs, or of effects. Least: what would be found "
      "with 80 % at a level of 5 % divided by their number. No family is added to another.");
}

void add_difference_plots(InstrumentReport& report, const LadderPlan& plan, const LadderResult& result,
                          const std::vector<LadderDifferenceData>& differences) {
  const auto million = [](double share) { return 1e6 * share; };
  const std::vector<std::string> ids = ids_of(plan.kernels);
  const auto rates = [&](std::size_t source, const char* what, std::initializer_list<Figure> figures) {
    InstrumentPlot plot{fmt::format("{}, {}", what, plan.sources[source]->name()),
                        "kernel",
                        "per million, 95 %",
                        InstrumentPlot::Kind::line,
                        false,
                        false,
                        {},
                        ids};
    for (const Figure figure : figures) {
      InstrumentSeries series{std::string(figure_names[figure]), {}, {}, {}};
      for (std::size_t k = 0; k < result.entries.size(); ++k) {
        const LadderRateData rate = ladder_rate(result, source, k, figure);
        if (!rate.low || !rate.high) continue;
        series.points.emplace_back(static_cast<double>(k), million(*rate.rate));
        series.intervals.emplace_back(million(*rate.low), million(*rate.high));
        series.labels.push_back(ids[k]);
      }
      plot.series.push_back(std::move(series));
    }
    report.plots.push_back(std::move(plot));
  };
  for (std::size_t s = 0; s < plan.sources.size(); ++s) {
    rates(s, "Wrong verdicts by rung", {Figure::missed, Figure::phantom});
    rates(s, "Sign errors by rung", {Figure::plane_signs, Figure::vertex_signs, Figure::edge_signs});
  }
  const auto effects = of_kind(differences, ContrastKind::effect);
  if (effects.empty()) return;
  for (const Figure figure : enumerators<Figure>) {
    InstrumentPlot plot{fmt::format("Main effects: {}", figure_names[figure]),
                        "factor",
                        "change per million, 95 %",
                        InstrumentPlot::Kind::scatter,
                        false,
                        false,
                        {},
                        {}};
    for (const SourcePtr& source : plan.sources) {
      InstrumentSeries series{source->name(), {}, {}, {}};
      for (const LadderDifferenceData* one : effects) {
        if (one->figure != figure_names[figure] || one->family != source->name() || !one->low || !one->high) continue;
        auto place = std::ranges::find(plot.x_names, *one->factor);
        if (place == plot.x_names.end()) place = plot.x_names.insert(place, *one->factor);
        const auto x = static_cast<double>(place - plot.x_names.begin());
        // Beside each other: a tenth of a place for each family.
        series.points.emplace_back(x + 0.1 * static_cast<double>(plot.series.size()), million(one->difference->value));
        series.intervals.emplace_back(million(one->low->value), million(one->high->value));
      }
      plot.series.push_back(std::move(series));
    }
    if (!plot.x_names.empty()) report.plots.push_back(std::move(plot));
  }
}

}  // namespace axiscert
