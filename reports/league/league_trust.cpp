#include "reports/league/league_trust.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr std::uint64_t rare = 1000;  // queries, of which less than one is wrong

}  // namespace

bool TrustGroup::has(std::string_view family) const {
  return std::any_of(families.begin(), families.end(), [&](std::string_view one) {
    return one.ends_with('*') ? family.starts_with(one.substr(0, one.size() - 1)) : family == one;
  });
}

const std::vector<TrustGroup>& trust_groups() {
  static const std::vector<TrustGroup> groups = {
      {"thin", {"sliver", "needle", "ratio"}},   {"small", {"subnormal", "scale"}},     {"far", {"far"}},
      {"degenerate", {"collinear", "repeated"}}, {"resting", {"tangent", "on", "tie"}}, {"scene", {"scene*"}}};
  return groups;
}

bool is_scene(std::string_view family) { return trust_groups().back().has(family); }

std::uint64_t answered(const Tally& tally) {
  return tally.trials - tally.invalid - tally.verdict.unanswered - tally.verdict.outside_limits.trials;
}

std::string trust_words(const Tally& tally) {
  const VerdictTally& verdict = tally.verdict;
  const std::uint64_t said = answered(tally) - verdict.undecided - verdict.invalid;
  const std::uint64_t missed = verdict.false_separation, invented = verdict.false_contact;
  std::string words;
  if (said == 0) {
    words = "nothing answered";
  } else if (missed + invented == 0) {
    words = fmt::format("yes: 0 of {} wrong", thousands(said));
  } else {
    words = (missed + invented) * rare < said ? "rarely: " : "no: ";
    if (missed != 0) words += fmt::format("{} of {} missed", thousands(missed), thousands(said));
    if (missed != 0 && invented != 0) words += fmt::format(", {} invented", thousands(invented));
    if (missed == 0) words += fmt::format("{} of {} invented", thousands(invented), thousands(said));
  }
  if (verdict.undecided != 0) words += fmt::format("; declines {}", thousands(verdict.undecided));
  if (verdict.invalid != 0) words += fmt::format("; calls {} invalid", thousands(verdict.invalid));
  if (verdict.unanswered != 0) words += fmt::format("; no answer to {}", thousands(verdict.unanswered));
  if (verdict.outside_limits.trials != 0) {
    words += fmt::format("; {} outside its limits", thousands(verdict.outside_limits.trials));
  }
  return words;
}

InstrumentTable trust_table(const League& league, const CampaignResult& result, Precision precision) {
  const Plan& plan = league.plan;
  InstrumentTable table{fmt::format("{}: may I trust it?", name(precision)), {"kernel"}, {}};
  std::vector<const TrustGroup*> groups;
  for (const TrustGroup& group : trust_groups()) {
    const auto is_asked = [&](const SourcePtr& source) { return group.has(source->name()); };
    if (std::none_of(plan.sources.begin(), plan.sources.end(), is_asked)) continue;
    groups.push_back(&group);
    table.columns.emplace_back(group.name);
  }
  table.columns.emplace_back("deepest miss");
  for (std::size_t k = 0; k < league.contenders; ++k) {
    if (!plan.kernels[k]->has(precision)) continue;
    std::vector<Tally> by_group(groups.size());
    Tally all;
    for (const CellResult& cell : result.cells) {
      if (cell.precision != precision) continue;
      all.merge(cell.tallies[k]);
      for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i]->has(plan.sources[cell.source]->name())) by_group[i].merge(cell.tallies[k]);
      }
    }
    auto& row = table.rows.emplace_back(std::vector<std::string>{plan.kernels[k]->id});
    for (const Tally& tally : by_group) row.push_back(trust_words(tally));
    row.push_back(all.verdict.false_separation == 0
                      ? "none"
                      : fmt::format("{:.3g}", all.verdict.deepest_false_separation.best()));
  }
  return table;
}

}  // namespace axiscert
