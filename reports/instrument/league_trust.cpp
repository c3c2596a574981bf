#include "reports/instrument/league_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "fuzz/record/looked_at.h"
#include "fuzz/text/number_text.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr std::uint64_t rare = 1000;  // queries, of which less than one is wrong

// None for queries of a file.
std::optional<TrustGroup> trust_group_of(const SourcePtr& source) {
  const std::string name = source->name();
  for (const Family* family : families()) {
    if (family->name == name) return family->trust_group;
  }
  return std::nullopt;
}

}  // namespace

std::uint64_t decided(const Tally& tally) { return looked_at_of(tally).decided; }

std::uint64_t decided_for(FlipKind kind, const Kernel& kernel, const Tally& tally) {
  return evidence_of(kernel.touching, tally).decided_for(kind);
}

namespace {

// "812 of 16,384 missed, 3 invented".
std::string wrong_words(const Tally& tally, std::uint64_t said) {
  const std::uint64_t missed = tally.verdict.false_separation, invented = tally.verdict.false_contact;
  if (missed == 0) return fmt::format("{} of {} invented", thousands(invented), thousands(said));
  std::string words = fmt::format("{} of {} missed", thousands(missed), thousands(said));
  if (invented != 0) words += fmt::format(", {} invented", thousands(invented));
  return words;
}

// Why so few are no evidence; empty where they are some.
std::string too_few_words(const Evidence& evidence, std::uint64_t said) {
  if (said < least_looked_at) return fmt::format("{} of {} decided", thousands(said), thousands(evidence.population));
  std::string words;
  const auto add = [&](std::uint64_t declined, std::uint64_t of, const char* what) {
    if (!words.empty() || !declines_too_many(declined, of, least_decided_share)) return;
    words = fmt::format("{} of {} {} decided", thousands(of - declined), thousands(of), what);
  };
  add(evidence.declined_contacts, evidence.contacts, "contacts");
  add(evidence.declined_separations, evidence.separations, "separations");
  return words;
}

}  // namespace

Trust trust_in(const Kernel& kernel, const Tally& tally) {
  const VerdictTally& verdict = tally.verdict;
  const LookedAt looked_at = looked_at_of(tally);
  const std::uint64_t said = looked_at.decided, wrong = verdict.false_separation + verdict.false_contact;
  Trust trust;
  if (looked_at.faults(kernel.may_decline) != 0 || (wrong != 0 && wrong * rare >= said)) {
    trust.answer = "no";
    trust.words = wrong == 0 ? fmt::format("0 of {} wrong", thousands(said)) : wrong_words(tally, said);
  } else if (wrong != 0) {
    trust.answer = "rarely";
    trust.words = wrong_words(tally, said);
  } else if (said == 0) {
    trust.answer = "not looked at";
    trust.words = fmt::format("0 of {} decided", thousands(tally.trials - tally.truth.invalid));
  } else if (std::string few = too_few_words(evidence_of(kernel.touching, tally), said); !few.empty()) {
    trust.answer = "too few";
    trust.words = std::move(few);
  } else {
    trust.answer = "yes";
    trust.words = fmt::format("0 of {} wrong", thousands(said));
  }
  if (verdict.undecided != 0) {
    trust.words += fmt::format("; declines {}{}", thousands(verdict.undecided),
                               kernel.may_decline ? "" : " and does not declare that it may");
  }
  if (verdict.invalid != 0) trust.words += fmt::format("; calls {} invalid", thousands(verdict.invalid));
  if (verdict.unanswered != 0) trust.words += fmt::format("; no answer to {}", thousands(verdict.unanswered));
  if (verdict.outside_limits->trials != 0) {
    trust.words += fmt::format("; {} outside its limits", thousands(verdict.outside_limits->trials));
  }
  return trust;
}

Tally tally_of_group(const League& league, const CampaignResult& result, std::size_t k, Precision precision,
                     std::optional<TrustGroup> group) {
  Tally all = empty_tally(*league.kernels[k]->predicate);
  for (const CellResult& cell : result.cells) {
    if (cell.precision != precision) continue;
    if (!group || trust_group_of(league.questions.sources[cell.source]) == group) all.merge(cell.tallies[k]);
  }
  return all;
}

std::vector<TrustGroup> groups_asked(const std::vector<SourcePtr>& sources) {
  std::vector<TrustGroup> groups;
  for (const TrustGroup group : enumerators<TrustGroup>) {
    const auto is_asked = [&](const SourcePtr& source) { return trust_group_of(source) == group; };
    if (std::any_of(sources.begin(), sources.end(), is_asked)) groups.push_back(group);
  }
  return groups;
}

InstrumentTable trust_table(const League& league, const CampaignResult& result, Precision precision) {
  InstrumentTable table{fmt::format("{}: may I trust it?", name(precision)), {"kernel"}, {}};
  const std::vector<TrustGroup> groups = groups_asked(league.questions.sources);
  for (const TrustGroup group : groups) table.columns.emplace_back(name(group));
  table.columns.emplace_back("deepest miss");
  for (std::size_t k = 0; k < league.contenders; ++k) {
    const Kernel& kernel = *league.kernels[k];
    if (!kernel.has(precision)) continue;
    auto& row = table.rows.emplace_back(std::vector<std::string>{kernel.id});
    for (const TrustGroup group : groups) {
      row.push_back(trust_in(kernel, tally_of_group(league, result, k, precision, group)).text());
    }
    const Tally all = tally_of_group(league, result, k, precision, std::nullopt);
    row.push_back(depth_text(all.verdict.false_separation, decided_for(FlipKind::false_separation, kernel, all),
                             all.verdict.deepest_false_separation.best()));
  }
  return table;
}

InstrumentFirst league_first(const League& league, const CampaignResult& result) {
  InstrumentFirst first{{"May I trust it?", {"kernel"}, {}}, {}, {}};
  const std::vector<TrustGroup> asked = groups_asked(league.questions.sources);
  const bool has_scenes = std::ranges::find(asked, TrustGroup::scene) != asked.end();
  std::vector<std::pair<std::optional<TrustGroup>, std::string>> kinds;
  if (has_scenes) kinds.emplace_back(TrustGroup::scene, "everyday scenes");
  kinds.emplace_back(std::nullopt, "all families");
  for (const auto& [group, words] : kinds) {
    std::vector<std::string> told;  // of each precision
    for (const Precision precision : league.questions.precisions) {
      first.table.columns.push_back(fmt::format("{}, {}", words, name(precision)));
      std::map<std::string, std::vector<std::string>> by_answer;
      for (std::size_t k = 0; k < league.contenders; ++k) {
        const Kernel& kernel = *league.kernels[k];
        if (first.table.rows.size() <= k) first.table.rows.push_back({kernel.id});
        std::string cell = "-";
        if (kernel.has(precision)) {
          const Tally tally = tally_of_group(league, result, k, precision, group);
          const Trust trust = trust_in(kernel, tally);
          cell = trust.text();
          if (const double farthest = tally.verdict.farthest(); group && farthest > 0)
            cell += fmt::format("; worst {}", metric_text(farthest));
          by_answer[trust.answer].push_back(kernel.id);
        }
        first.table.rows[k].push_back(std::move(cell));
      }
      const std::vector<std::string>& right = by_answer["yes"];
      told.push_back(
          (right.empty() ? "nobody is right throughout" : fmt::format("right throughout: {}", fmt::join(right, ", "))) +
          (by_answer["rarely"].empty() ? "."
                                       : fmt::format("; rarely wrong: {}.", fmt::join(by_answer["rarely"], ", "))));
    }
    std::string heading = words;
    heading[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(heading[0])));
    // Once where every precision has the same.
    const bool are_same = told.size() > 1 && std::ranges::count(told, told.front()) == std::ssize(told);
    for (std::size_t i = 0; i < (are_same ? 1 : told.size()); ++i) {
      const std::string of = are_same ? "" : fmt::format(", {}", name(league.questions.precisions[i]));
      first.sentences.push_back(fmt::format("{}{}: {}", heading, of, told[i]));
    }
  }
  if (const std::optional<WorstQuery> worst = worst_scene_of(league, result)) {
    first.worst = worst_scene(*worst, league.questions.seed);
    first.worst->title =
        fmt::format("{}: {}", worst->is_everyday() ? "The worst everyday scene" : "The deepest", first.worst->title);
  }
  return first;
}

std::string depth_text(std::uint64_t missed, std::uint64_t contacts, double deepest) {
  if (contacts == 0) return "not measured";
  if (missed == 0) return fmt::format("none of {}", thousands(contacts));
  return deepest == 0 ? "0" : fmt::format("{:.3g}", deepest);
}

}  // namespace axiscert
