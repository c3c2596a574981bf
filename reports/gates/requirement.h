// The requirements of a record, and what came of them: a level is met, not met, or not checked, for each kernel and
// precision. Each level is in a file of its own, NAME_level.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/record/record.h"
#include "fuzz/record/run_info.h"
#include "reports/gates/level.h"

namespace axiscert {

enum class LevelState { met, not_met, not_checked };
template <>
inline constexpr std::size_t enum_count<LevelState> = 3;
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
  Evidence evidence = {};                    // of the families that the level requires
  std::uint64_t looked_at = 0;               // queries, or pairs of them, of these families that it judged
  std::uint64_t concerned = 0;               // those that it is about
  std::size_t families = 0;                  // that it requires, and that have a valid query
  std::vector<std::string> outside = {};     // of these, those without a query that the kernel promises
  bool has_limits = false;                   // the kernel promises less than everything
  std::uint64_t lines_left_out = 0;          // of files, in a precision in which they were not asked

  bool passes() const { return state == LevelState::met || is_allowed; }
  bool is_of(const KernelRecord& entry) const;  // whether it is about this kernel of the record
  // "exact", or of a kernel with limits "exact within its limits: 19 of 27 families".
  std::string claim() const;
  // "1 of 45 promised queries looked at, 44 declined, 2,655 of 2,700 outside its limits"; empty where nothing could be
  // asked.
  std::string looked_text() const;
  // "published binary32: exact: " and looked_text(), then ": NOT CHECKED: no query ...", without the failures, which
  // have lines of their own.
  std::string text() const;
  std::optional<std::string> judged_precision() const {
    return precision.empty() ? std::nullopt : std::optional(precision);
  }
  AXISCERT_FIELDS(
      LevelOutcome, inlined(&Of::asked), AXISCERT_FIELD(kernel, "The kernel's id."), journalled(&Of::precision),
      field(&Of::judged_precision, {"precision", "Null for a kernel that could not be loaded."}),
      AXISCERT_FIELD(state, "NOT CHECKED: these queries, or what the kernel shows, cannot say."),
      field(&Of::is_allowed, {"allowed", "Whether it is not checked and --allow-unchecked names it."}),
      AXISCERT_FIELD(reason, "Why it is not checked; empty otherwise."),
      AXISCERT_FIELD(covers, "What 'met' says of this kernel; empty where it is not met."),
      AXISCERT_FIELD(leaves_out, "What 'met' does not say."),
      AXISCERT_FIELD(text, "The whole in one sentence: how much was looked at, and what came of it."),
      AXISCERT_FIELD(failures, "Where it is not met."), journalled(&Of::unseen),
      AXISCERT_FIELD(evidence, Evidence::about),
      AXISCERT_FIELD(looked_at, "Queries that the level judged; for some families pairs of a query and its image."),
      AXISCERT_FIELD(concerned, "Those that it is about."),
      AXISCERT_FIELD(families, "Families that the level requires and that have a valid query."),
      field(&Of::outside, {"outside_limits", "Of these, those without a query that the kernel promises.", "families"}),
      journalled(&Of::has_limits), journalled(&Of::lines_left_out))
};

// run.json, with what came of each level of --require.
struct RunFile : RunInfo {
  std::optional<std::vector<LevelOutcome>> requirements;

  AXISCERT_FIELDS(RunFile, base<RunFile, RunInfo>(),
                  AXISCERT_OPTIONAL_FIELD(requirements,
                                          "What came of each level of --require, for each kernel and precision."))
};

// Parses a level. Throws Error that lists them, or says what its argument has to be.
AskedLevel parse_level(const std::string& text);
const GateLevel& level_of(const AskedLevel& asked);  // of one that was parsed
// The sentence of a level: what it requires, and what every level does.
std::string sentence_of(const AskedLevel& asked);
// Lists the levels with their meanings, for --help.
std::string levels_help();

// The requirements of a plan: the levels, and those of them that may be left unchecked.
struct Requirements {
  std::vector<AskedLevel> levels;
  std::vector<std::string> allowed;  // as in `text` or `name` of a level
};
// Throws Error as parse_level does, and for an allowed level that is not required.
Requirements requirements_of(const PlanRecord& plan);
// The kernels that levels measure others against: they have to meet no level themselves.
std::vector<std::string> yardsticks_of(const PlanRecord& plan);

// The outcomes of what the record's plan requires: by level, then in the order of the record's kernels, those that
// could not be loaded first.
//
// Against every level stand, one being enough: a finding, and a valid query within the kernel's limits that it did not
// answer, called invalid, or declined without declaring that it may.
//
// A level is checked where the run was not interrupted, the kernel decided a query, and of each family that the level
// requires
// - least_looked_at queries were looked at, or all that the level concerns where a file, or the level, concerns fewer;
// a
//   family all of which is outside the kernel's limits is named instead, unless all are;
// - a kernel that may decline decided its share of the contacts and of the separations (least_decided_share);
// and where of the contacts of these families, and of the separations, least_of_each_kind were decided, or all.
//
// Empty where nothing is required. Throws Error as requirements_of does.
std::vector<LevelOutcome> outcomes_of(const Record& record);
// The same for one level, whatever the plan requires.
std::vector<LevelOutcome> outcomes_at(const Record& record, const std::string& level);

// The worst of what came of the levels for one kernel of the record: not met, then not checked, then what
// may be left unchecked. Null where nothing is required of it.
const LevelOutcome* worst_of(const std::vector<LevelOutcome>& outcomes, const KernelRecord& kernel);
// "met", "not met", "NOT CHECKED", "NOT CHECKED, which is allowed"; "none given" where nothing is required.
std::string state_text(const LevelOutcome* worst);

// Whether nothing is required, or everything that is passes.
bool pass(const std::vector<LevelOutcome>& outcomes);
// The failures of all outcomes, each once: a finding fails every level.
std::vector<Failure> failures_of(const std::vector<LevelOutcome>& outcomes);

// The failures of a record at a level; empty where no kernel fails it, which does not mean that it was checked.
std::vector<Failure> unmet(const Record& record, const std::string& level);

// The part of a plan that a run did not judge. A run in which there is anything of it never exits with 0, whatever was
// required of it.

// Sentences, one for each kernel of the plan that could not be loaded, that has a family without a valid query in any
// of its precisions, or that has valid queries outside its limits only. Empty where the whole plan was judged.
std::vector<std::string> unjudged(const Record& record);

// The levels with which a report begins.

struct FirstLevels {
  bool are_required;  // else they are those that are advised
  std::string lead;   // a sentence
  std::vector<LevelOutcome> outcomes;
};
FirstLevels first_levels(const Record& record);

// Where it is not met, the first way; why it is not checked; empty where it is met.
std::string reason_text(const LevelOutcome& outcome);

}  // namespace axiscert
