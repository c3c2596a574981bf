// The requirements of a record, and what came of them: a level is met, not met, or not checked, for each kernel and
// precision. The levels themselves are in levels/.
#pragma once

#include <string>
#include <vector>

#include "fuzz/text/json.h"
#include "reports/gates/levels/level.h"

namespace axiscert {

enum class LevelState { met, not_met, not_checked };
std::string_view name(LevelState state);  // "met", "not met", "NOT CHECKED"

// The outcome of a level for one kernel in one precision.
struct LevelOutcome {
  AskedLevel asked;
  std::string kernel = {}, precision = {};  // precision is empty for a kernel that could not be loaded
  LevelState state = LevelState::met;
  bool is_allowed = false;                   // not checked, and the user said that this may be
  std::string reason = {};                   // why it is not checked; empty where it is
  std::string covers = {}, leaves_out = {};  // what "met" says and what it does not; empty where it is not met
  std::vector<Failure> failures = {};        // where it is not met
  std::vector<std::string> unseen = {};      // families on which this kernel cannot be seen to fail it

  bool passes() const { return state == LevelState::met || is_allowed; }
  bool is_of(const Json& kernel) const;  // whether it is about this entry of the record's "kernels"
  // "published binary32: logic: NOT CHECKED: no query ...", without the failures, which have lines of their own.
  std::string text() const;
};

// Parses a level. Throws Error that lists them, or says what its argument has to be.
AskedLevel parse_level(const std::string& text);
// The sentence of a level: what it requires, and what every level does.
std::string sentence_of(const AskedLevel& asked);
// Lists the levels with their meanings, for --help.
std::string levels_help();

// The requirements of a plan: its member "require" is null, a level or a list of levels, and "allow_unchecked", where
// it is there, lists those that may be left unchecked.
struct Requirements {
  std::vector<AskedLevel> levels;
  std::vector<std::string> allowed;  // as in `text` or `name` of a level
};
// Throws Error as parse_level does, and for an allowed level that is not required.
Requirements requirements_of(const Json& plan);
// The kernels that levels measure others against: they have to meet no level themselves.
std::vector<std::string> yardsticks_of(const Json& plan);

// The outcomes of what the record's plan requires: by level, then in the order of the record's kernels, those that
// could not be loaded first. A kernel with a finding, or with a query within its limits that it did not answer, meets
// no level; queries outside the limits do not count at any. A kernel of which no query was decided, and a record with a
// family without queries, are not checked. Empty where nothing is required. Throws Error as requirements_of does.
std::vector<LevelOutcome> outcomes_of(const Json& record);
// The same for one level, whatever the plan requires.
std::vector<LevelOutcome> outcomes_at(const Json& record, const std::string& level);

// The worst of what came of the levels for one entry of the record's "kernels": not met, then not checked, then what
// may be left unchecked. Null where nothing is required of it.
const LevelOutcome* worst_of(const std::vector<LevelOutcome>& outcomes, const Json& kernel);
// "met", "not met", "NOT CHECKED", "NOT CHECKED, which is allowed"; "none given" where nothing is required.
std::string state_text(const LevelOutcome* worst);

// Whether nothing is required, or everything that is passes.
bool pass(const std::vector<LevelOutcome>& outcomes);
// The failures of all outcomes, each once: a finding fails every level.
std::vector<Failure> failures_of(const std::vector<LevelOutcome>& outcomes);
// For run.json and the page.
Json outcomes_json(const std::vector<LevelOutcome>& outcomes);

// The failures of a record at a level; empty where no kernel fails it, which does not mean that it was checked.
std::vector<Failure> unmet(const Json& record, const std::string& level);

}  // namespace axiscert
