#include "reports/certificate/levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>

#include "fuzz/queries/source.h"
#include "kernel/kernel.h"
#include "reports/wording/evidence.h"
#include "reports/gates/requirement.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr std::size_t most_failures = 5;

double number_of(const std::string& text) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc() ? value : std::numeric_limits<double>::infinity();
}

// A search for the worst wrong verdicts, and the rate of them, say something of these levels.
bool is_of_verdicts(const AskedLevel& asked) { return level_of(asked).allowed != nullptr; }

// How a find of a search contradicts a level; empty where it does not, or that cannot be told.
std::string contradiction(const AskedLevel& asked, const SearchedStatement* search) {
  if (search == nullptr || !is_of_verdicts(asked)) return "";
  const auto of = [&](const char* goal, const char* what, double most) -> std::string {
    const FindStatement* find = search->find(goal);
    if (find == nullptr || !find->depth || number_of(*find->depth) <= most) return "";
    return fmt::format("the search found a {} of depth {} of the scene", what, *find->depth);
  };
  const AllowedDepths allowed = level_of(asked).allowed(asked);
  const std::string missed = of("missed_contact", "missed contact", allowed.missed);
  return missed.empty() ? of("phantom_contact", "phantom contact", allowed.phantom) : missed;
}

// Whether the search decided queries for every goal that the level limits.
bool has_looked_against(const AskedLevel& asked, const SearchedStatement& search) {
  const bool allows_phantoms = level_of(asked).allowed(asked).phantom == any_depth;
  return search.looked_at_for("missed_contact") != 0 &&
         (allows_phantoms || search.looked_at_for("phantom_contact") != 0);
}

// How a diagnosis contradicts a level.
std::string contradiction(const AskedLevel& asked, const DiagnosedStatement* diagnosed) {
  const auto is_denied_by = level_of(asked).is_denied_by;
  if (diagnosed == nullptr || is_denied_by == nullptr) return "";
  for (const PropertyStatement& property : diagnosed->properties) {
    if (is_denied_by(asked, property.name, property.value))
      return fmt::format("the diagnosis found otherwise: {}", property.sentence);
  }
  return "";
}

std::string observed_text(const KernelRecord& kernel, const AskedLevel& asked, const std::string& covers) {
  if (!is_of_verdicts(asked)) return covers;
  const std::optional<FamilyRecord> total = all_families(kernel);
  if (!total) return covers;
  const double limit = zero_limit_per_million(kernel, *total);
  if (limit < 0) return covers;
  return fmt::format(
      "{}; where nothing was found, its rate is below {} per million queries of these generators, with 95 % (each "
      "triangle counted once)",
      covers, amount(limit, 3));
}

const KernelRecord* record_entry_of(const Record& record, const LevelOutcome& outcome) {
  for (const KernelRecord& kernel : record.kernels) {
    if (outcome.is_of(kernel)) return &kernel;
  }
  return nullptr;
}

LevelStatement level_statement(const Record& record, const LevelOutcome& outcome, const SearchedStatement* search,
                               const DiagnosedStatement* diagnosed) {
  LevelStatement level;
  level.level = outcome.asked.text;
  if (!outcome.precision.empty()) level.precision = parse_precision(outcome.precision);
  level.state = outcome.state;
  level.claim = outcome.claim();
  level.looked_at = outcome.looked_text();
  level.statement = sentence_of(outcome.asked);
  level.failure_count = outcome.failures.size();
  for (const std::string& found : {contradiction(outcome.asked, search), contradiction(outcome.asked, diagnosed)}) {
    if (found.empty()) continue;
    level.state = LevelState::not_met;
    level.failures.push_back(found);
    ++level.failure_count;
  }
  for (const Failure& f : outcome.failures) {
    if (level.failures.size() == most_failures) break;
    level.failures.push_back(f.family.empty() ? f.what
                                              : fmt::format("{}: {}: {}", f.family, f.what, thousands(f.count)));
  }
  const auto put = [](std::optional<SaidText>& into, const std::string& text) {
    if (!text.empty()) into = text;
  };
  if (level.state == LevelState::not_checked) put(level.reason, outcome.reason);
  if (level.state != LevelState::met) return level;
  put(level.leaves_out, outcome.leaves_out);
  if (const std::string proof = proved_at(outcome.kernel, outcome.asked); !proof.empty())
    level.rests_on.push_back({Ground::proved, proof});
  const KernelRecord* entry = record_entry_of(record, outcome);
  level.rests_on.push_back(
      {Ground::observed, entry ? observed_text(*entry, outcome.asked, outcome.covers) : outcome.covers});
  if (search != nullptr && is_of_verdicts(outcome.asked) && has_looked_against(outcome.asked, *search)) {
    level.rests_on.push_back(
        {Ground::searched, fmt::format("{} evaluations of a search for the worst found nothing against it",
                                       thousands(search->evaluations))});
  }
  return level;
}

}  // namespace

std::string proved_at(const std::string& kernel, const AskedLevel& asked) {
  const auto found = std::ranges::find(kernels(), kernel, &Kernel::id);
  if (found == kernels().end()) return "";
  const GateLevel& level = level_of(asked);
  const bool follows = found->proved == ProvedProperty::no_wrong_verdict
                           ? level.allowed != nullptr || level.is_about_causes
                           : level.allowed != nullptr && level.allowed(asked).phantom == any_depth;
  return follows ? std::string(found->proof) : "";
}

std::vector<std::string> levels_asked(const std::vector<std::string>& yardsticks) {
  std::vector<std::string> asked;
  for (const GateLevel* level : gate_levels()) {
    for (const std::string_view argument : level->in_certificates)
      asked.push_back(argument.empty() ? std::string(level->name()) : fmt::format("{}={}", level->name(), argument));
    if (level->yardstick == nullptr) continue;
    for (const std::string& id : yardsticks) asked.push_back(fmt::format("{}={}", level->name(), id));
  }
  return asked;
}

std::vector<LevelStatement> levels_of(const Record& record, const std::string& kernel,
                                      const NamedValues<SearchedStatement>& searches,
                                      std::span<const DiagnosedStatement> diagnosed) {
  std::vector<LevelStatement> levels;
  std::vector<std::string> yardsticks;
  for (const Name& id : record.plan.kernels) {
    if (id != kernel) yardsticks.push_back(id);
  }
  for (const std::string& level : levels_asked(yardsticks)) {
    for (const LevelOutcome& outcome : outcomes_at(record, level)) {
      if (outcome.kernel != kernel) continue;
      const auto like = std::ranges::find_if(
          diagnosed, [&](const DiagnosedStatement& part) { return name(part.precision) == outcome.precision; });
      levels.push_back(level_statement(record, outcome, searches.find(outcome.precision),
                                       like == diagnosed.end() ? nullptr : &*like));
    }
  }
  return levels;
}

}  // namespace axiscert
