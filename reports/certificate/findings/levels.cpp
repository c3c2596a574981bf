#include "reports/certificate/findings/levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "fuzz/queries/image_groups.h"
#include "kernel/base/error.h"
#include "reports/evidence/evidence.h"
#include "reports/gates/requirement.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// The depth of `depth=D` and `conservative=D`: a thousandth of the scene, which is seen in a game.
constexpr std::string_view depth_asked = "0.001";
constexpr std::size_t most_failures = 5;

struct ProvedLevel {
  std::string_view kernel, levels;  // levels: separated by blanks, each with one before and after it
  std::string_view text;
};
constexpr ProvedLevel proved_levels[] = {
    {"certified", " logic range exact conservative conservative=0.001 depth=0.001 ",
     "where the numbers are multiples of one power of two by integers of at most 126 bits: that the verdict is right, "
     "by Coq (certified_is_exact_within_126_bits), of margins recorded from the code, if its integers are long enough "
     "and the signs told by the steps before are right. Coq proves the latter of the coarse step "
     "(coarse_known_is_sound64). Of the fine step it proves, where nothing underflows, that margins are within their "
     "bounds (fine_is_near); the signs, and the deep step, are argued and tested, and so are wider numbers. "
     "docs/proofs.md#the-certified-predicate-step-by-step has what is trusted besides"},
    {"conservative", " conservative ",
     "where the square of the scene's size is from 2^-42 to 2^60 in binary32, 2^-400 to 2^400 in binary64: that no "
     "contact is missed, by Coq, of the code as recorded (recorded_conservative_is_right32, "
     "recorded_conservative_is_right64). Other sizes, which are scaled first, are argued on paper: "
     "docs/proofs.md#the-conservative-test-of-the-certified-predicate"},
};

double number_of(const Json& figure) {
  if (figure.is_number()) return figure.get<double>();
  const auto& text = figure.get_ref<const std::string&>();
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc() ? value : std::numeric_limits<double>::infinity();
}

// Whether a level is about wrong verdicts alone, so that a search for the worst, and the rate of them, say something.
bool is_of_verdicts(const std::string& level) {
  return level == "exact" || level == "depth" || level == "conservative";
}

// How a find of a search contradicts a level; empty where it does not, or that cannot be told.
std::string contradiction(const LevelOutcome& outcome, const Json& search) {
  if (search.is_null()) return "";
  const std::string& level = outcome.asked.name;
  const bool has_depth = outcome.asked.has_argument && (level == "depth" || level == "conservative");
  const double allowed = has_depth ? number_of(Json(outcome.asked.argument)) : -1;
  const auto of = [&](const char* goal, const char* what, double most) -> std::string {
    const Json& find = search["finds"].value(goal, Json());
    if (find.is_null() || number_of(find["depth"]) <= most) return "";
    return fmt::format("the search found a {} of depth {} of the scene", what, find["depth"].get<std::string>());
  };
  if (!is_of_verdicts(level)) return "";
  const double any = std::numeric_limits<double>::infinity();
  const std::string missed = of("missed_contact", "missed contact", level == "depth" ? allowed : -1);
  const std::string phantom = of("phantom_contact", "phantom contact",
                                 level == "exact" ? -1
                                 : has_depth      ? allowed
                                                  : any);
  return missed.empty() ? phantom : missed;
}

std::string observed(const KernelRecord& kernel, const std::string& level, const std::string& covers) {
  if (!is_of_verdicts(level)) return covers;
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
  if (const std::string found = contradiction(outcome, search); !found.empty()) {
    state = "not met";
    failures.insert(failures.begin(), Json(found));
    ++failure_count;
    while (failures.size() > most_failures) failures.erase(failures.size() - 1);
  }
  if (state == "met") {
    if (const std::string proof = proved_at(outcome.kernel, outcome.asked.text); !proof.empty())
      rests.push_back({{"kind", "proved"}, {"text", proof}});
    const KernelRecord* entry = record_entry_of(record, outcome);
    rests.push_back({{"kind", "observed"},
                     {"text", entry ? observed(*entry, outcome.asked.name, outcome.covers) : outcome.covers}});
    if (!search.is_null() && is_of_verdicts(outcome.asked.name)) {
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

std::string proved_at(const std::string& kernel, const std::string& level) {
  for (const ProvedLevel& proved : proved_levels) {
    if (proved.kernel == kernel && proved.levels.find(fmt::format(" {} ", level)) != std::string_view::npos)
      return std::string(proved.text);
  }
  return "";
}

std::vector<std::string> levels_asked(const std::vector<std::string>& yardsticks) {
  std::vector<std::string> asked;
  for (const GateLevel* level : gate_levels()) {
    const std::string name(level->name());
    const std::string_view usage = level->usage;
    const bool has_to = usage.find('=') != usage.npos && usage.find('[') == usage.npos;
    if (!has_to) asked.push_back(name);
    if (usage.ends_with("=D") || usage.ends_with("=D]")) asked.push_back(fmt::format("{}={}", name, depth_asked));
    if (usage.ends_with("=KIND")) {
      for (const std::string_view kind : image_kind_names) asked.push_back(fmt::format("{}={}", name, kind));
    }
    if (level->yardstick != nullptr) {
      for (const std::string& id : yardsticks) asked.push_back(fmt::format("{}={}", name, id));
    }
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
