#include "reports/certificate/findings/levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>

#include "kernel/kernel.h"
#include "reports/evidence/evidence.h"
#include "reports/gates/requirement.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr std::size_t most_failures = 5;

double number_of(const Json& figure) {
  if (figure.is_number()) return figure.get<double>();
  const auto& text = figure.get_ref<const std::string&>();
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc() ? value : std::numeric_limits<double>::infinity();
}

// A search for the worst wrong verdicts, and the rate of them, say something of these levels.
bool is_of_verdicts(const AskedLevel& asked) { return level_of(asked).allowed != nullptr; }

// How a find of a search contradicts a level; empty where it does not, or that cannot be told.
std::string contradiction(const AskedLevel& asked, const Json& search) {
  if (search.is_null() || !is_of_verdicts(asked)) return "";
  const auto of = [&](const char* goal, const char* what, double most) -> std::string {
    const Json& find = search["finds"].value(goal, Json());
    if (find.is_null() || number_of(find["depth"]) <= most) return "";
    return fmt::format("the search found a {} of depth {} of the scene", what, find["depth"].get<std::string>());
  };
  const AllowedDepths allowed = level_of(asked).allowed(asked);
  const std::string missed = of("missed_contact", "missed contact", allowed.missed);
  return missed.empty() ? of("phantom_contact", "phantom contact", allowed.phantom) : missed;
}

std::string observed(const KernelRecord& kernel, const AskedLevel& asked, const std::string& covers) {
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

Json level_json(const Record& record, const LevelOutcome& outcome, const Json& search) {
  Json rests = Json::array(), failures = Json::array();
  std::size_t failure_count = outcome.failures.size();
  std::string_view state = name(outcome.state);
  for (std::size_t i = 0; i < std::min(most_failures, failure_count); ++i) {
    const Failure& f = outcome.failures[i];
    failures.push_back(f.family.empty() ? f.what : fmt::format("{}: {}: {}", f.family, f.what, thousands(f.count)));
  }
  if (const std::string found = contradiction(outcome.asked, search); !found.empty()) {
    state = "not met";
    failures.insert(failures.begin(), Json(found));
    ++failure_count;
    while (failures.size() > most_failures) failures.erase(failures.size() - 1);
  }
  if (state == "met") {
    if (const std::string proof = proved_at(outcome.kernel, outcome.asked); !proof.empty())
      rests.push_back({{"kind", "proved"}, {"text", proof}});
    const KernelRecord* entry = record_entry_of(record, outcome);
    rests.push_back(
        {{"kind", "observed"}, {"text", entry ? observed(*entry, outcome.asked, outcome.covers) : outcome.covers}});
    if (!search.is_null() && is_of_verdicts(outcome.asked)) {
      rests.push_back({{"kind", "searched"},
                       {"text", fmt::format("{} evaluations of a search for the worst found nothing against it",
                                            thousands(search["evaluations"].get<std::uint64_t>()))}});
    }
  }
  const auto given = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
  return {{"level", outcome.asked.text},
          {"precision", given(outcome.precision)},
          {"state", state},
          {"claim", outcome.claim()},
          {"looked_at", outcome.looked_text()},
          {"statement", sentence_of(outcome.asked)},
          {"rests_on", rests},
          {"leaves_out", given(state == "met" ? outcome.leaves_out : "")},
          {"failures", failures},
          {"failure_count", failure_count},
          {"reason", given(state == name(LevelState::not_checked) ? outcome.reason : "")}};
}

}  // namespace

std::string proved_at(const std::string& kernel, const AskedLevel& asked) {
  const auto found = std::ranges::find(kernels(), kernel, &Kernel::id);
  if (found == kernels().end()) return "";
  const GateLevel& level = level_of(asked);
  const bool follows = found->proved == Proved::no_wrong_verdict
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

Json levels_json(const Record& record, const std::string& kernel, const Json& searches) {
  Json levels = Json::array();
  std::vector<std::string> yardsticks;
  for (const Name& id : record.plan.kernels) {
    if (id != kernel) yardsticks.push_back(id);
  }
  for (const std::string& level : levels_asked(yardsticks)) {
    for (const LevelOutcome& outcome : outcomes_at(record, level)) {
      if (outcome.kernel != kernel) continue;
      levels.push_back(level_json(record, outcome, searches.value(outcome.precision, Json())));
    }
  }
  return levels;
}

}  // namespace axiscert
