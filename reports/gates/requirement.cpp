#include "reports/gates/requirement.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "kernel/base/error.h"
#include "reports/gates/enough.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

const GateLevel* find_level(const std::string& name) {
  for (const GateLevel* level : gate_levels()) {
    if (level->name() == name) return level;
  }
  return nullptr;
}

std::vector<std::string_view> gate_level_names() {
  std::vector<std::string_view> names;
  for (const GateLevel* level : gate_levels()) names.push_back(level->name());
  return names;
}

std::vector<std::string_view> usages() {
  std::vector<std::string_view> usages;
  for (const GateLevel* level : gate_levels()) usages.emplace_back(level->usage);
  return usages;
}

Failure failure_of_finding(const FindingRecord& finding) {
  return {finding.kernel, std::string(finding.precision ? name(*finding.precision) : ""), finding.family.value_or(""),
          finding.count,  fmt::format("{}: {}", name(finding.kind), finding.detail),      ""};
}

// The failures that fail every level.
std::vector<Failure> failures_anywhere(const Record& record, const Subject& subject, const AskedLevel& asked) {
  std::vector<Failure> failures;
  for (const FindingRecord& finding : record.findings) {
    const bool is_here = !finding.family || asked.is_about(*finding.family);
    if (is_here && is_about(finding, subject.kernel())) failures.push_back(failure_of_finding(finding));
  }
  const auto nothing = [](const FlipRecord&) { return false; };  // such an answer is not a flip
  for (const auto& [family, result] : subject.families()) {
    const Evidence evidence = subject.evidence(result);
    subject.add(failures, family, evidence.unanswered, "valid queries without an answer", nothing);
    subject.add(failures, family, evidence.invalid, "answers `invalid` to valid queries", nothing);
    if (!subject.kernel().may_decline) {
      subject.add(failures, family, result.verdict.undecided,
                  "valid queries declined by a kernel that does not declare may_decline", nothing);
    }
    subject.add(failures, family, result.critical_radius.unanswered, "searches for a critical radius without an answer",
                nothing);
  }
  return failures;
}

// How many queries were asked in another order too: a finding of what that shows fails every level.
std::string asked_again_text(const Subject& subject) {
  std::uint64_t again = 0;
  for (const auto& [family, result] : subject.families()) again += result.asked_again.value_or(0);
  return again == 0 ? "" : fmt::format("; {} queries asked again, in another order or alone", thousands(again));
}

// The entry with those families alone that the level is about; empty where that is all.
std::optional<KernelRecord> narrowed(const KernelRecord& kernel, const AskedLevel& asked) {
  if (asked.families.empty()) return std::nullopt;
  KernelRecord part = kernel;
  part.families = {};
  for (const auto& [family, result] : kernel.families) {
    if (asked.is_about(family)) part.families.put(family) = result;
  }
  return part;
}

LevelOutcome outcome_of(const Record& record, const KernelRecord& whole, const AskedLevel& asked, double share) {
  const std::optional<KernelRecord> part = narrowed(whole, asked);
  const KernelRecord& kernel = part ? *part : whole;
  const Subject subject(record, kernel);
  LevelOutcome outcome{asked, kernel.id, std::string(name(kernel.precision))};
  outcome.failures = failures_anywhere(record, subject, asked);
  LevelFindings found = level_of(asked).judge(asked, subject);
  outcome.unseen = std::move(found.unseen);
  outcome.failures.insert(outcome.failures.end(), found.failures.begin(), found.failures.end());
  const std::string too_little = weigh(subject, found, share, outcome);
  outcome.unseen.insert(outcome.unseen.end(), outcome.outside.begin(), outcome.outside.end());
  if (!outcome.failures.empty()) {
    outcome.state = LevelState::not_met;
    return outcome;
  }
  outcome.reason = gap_of(record, subject, asked);
  if (outcome.reason.empty()) outcome.reason = found.not_checked.empty() ? too_little : found.not_checked;
  if (!outcome.reason.empty()) {
    outcome.state = LevelState::not_checked;
    return outcome;
  }
  outcome.covers = found.covers + fewest_text(subject, found, asked) + asked_again_text(subject);
  outcome.leaves_out = std::move(found.leaves_out);
  const bool looks_outside = level_of(asked).looks_at != nullptr;
  if (!looks_outside && !outcome.outside.empty())
    leave_out(outcome.leaves_out, fmt::format("outside its limits: {}", fmt::join(outcome.outside, ", ")));
  else if (!looks_outside && outcome.evidence.outside != 0)
    leave_out(outcome.leaves_out, fmt::format("{} queries outside its limits", thousands(outcome.evidence.outside)));
  if (outcome.evidence.declined() != 0) leave_out(outcome.leaves_out, "what it declined");
  for (const auto& untaken : {lines_it_cannot_take(record, kernel.id), lines_left_out(record)}) {
    for (const UntakenLines& lines : untaken) {
      if (!asked.is_about(lines.family)) continue;
      leave_out(outcome.leaves_out, lines.text());
      outcome.lines_left_out += lines.count;
    }
  }
  if (outcome.leaves_out.empty()) outcome.leaves_out = "nothing";
  return outcome;
}

// The share of each family that a kernel which may decline has to decide: the greatest that is required.
double decided_share(const std::vector<AskedLevel>& levels) {
  std::optional<double> share;
  for (const AskedLevel& asked : levels) {
    if (const auto own = level_of(asked).decided_share) share = std::max(share.value_or(0), own(asked));
  }
  return share.value_or(least_decided_share);
}

std::vector<std::string> yardsticks(const std::vector<AskedLevel>& levels) {
  std::vector<std::string> kernels;
  for (const AskedLevel& asked : levels) {
    if (const auto yardstick = level_of(asked).yardstick) kernels.push_back(yardstick(asked));
  }
  return kernels;
}

std::vector<LevelOutcome> outcomes(const Record& record, const Requirements& required) {
  std::vector<LevelOutcome> all;
  const std::vector<std::string> unloaded = not_judged(record), exempt = yardsticks(required.levels);
  const double share = decided_share(required.levels);
  for (const AskedLevel& asked : required.levels) {
    for (const std::string& id : unloaded) {
      LevelOutcome outcome{asked, id, "", LevelState::not_met};
      for (const FindingRecord& finding : record.findings) {
        if (finding.kernel == id) outcome.failures.push_back(failure_of_finding(finding));
      }
      all.push_back(std::move(outcome));
    }
    const std::size_t before = all.size();
    for (const KernelRecord& kernel : record.kernels) {
      if (std::find(exempt.begin(), exempt.end(), kernel.id) == exempt.end())
        all.push_back(outcome_of(record, kernel, asked, share));
    }
    if (all.size() != before || !unloaded.empty()) continue;
    for (const KernelRecord& kernel : record.kernels) {
      LevelOutcome outcome{asked, kernel.id, std::string(name(kernel.precision)), LevelState::not_checked};
      outcome.reason = "others are measured against it, and no other kernel was run";
      all.push_back(std::move(outcome));
    }
  }
  for (LevelOutcome& outcome : all) {
    const auto is_it = [&](const std::string& name) {
      return name == outcome.asked.text || name == outcome.asked.name;
    };
    outcome.is_allowed = outcome.state == LevelState::not_checked &&
                         std::any_of(required.allowed.begin(), required.allowed.end(), is_it);
  }
  return all;
}

}  // namespace

std::string_view name(LevelState state) {
  switch (state) {
    case LevelState::met:
      return "met";
    case LevelState::not_met:
      return "not met";
    case LevelState::not_checked:
      break;
  }
  return "NOT CHECKED";
}

bool LevelOutcome::is_of(const KernelRecord& entry) const {
  return entry.id == kernel && (precision.empty() || name(entry.precision) == precision);
}

std::string LevelOutcome::claim() const {
  if (!has_limits || families == 0) return asked.text;
  return fmt::format("{} within its limits: {} of {} families", asked.text, families - outside.size(), families);
}

std::string LevelOutcome::looked_text() const {
  const std::string lines =
      lines_left_out == 0 ? "" : fmt::format("{} lines of files left out", thousands(lines_left_out));
  if (families == 0) return lines;  // it looks at queries of its own
  const char* const others = level_of(asked).looks_at;
  const auto part_of = level_of(asked).part;
  const char* const part = part_of == nullptr ? nullptr : part_of(asked);
  std::string text = others != nullptr
                         ? fmt::format("{} of {} {} looked at", thousands(looked_at), thousands(concerned), others)
                     : part == nullptr ? evidence_text(evidence, looked_at)
                                       : evidence_text(evidence, looked_at, concerned, part);
  return lines.empty() ? text : text + ", " + lines;
}

std::string LevelOutcome::text() const {
  const std::string who = precision.empty() ? kernel : fmt::format("{} {}", kernel, precision);
  std::string text = fmt::format("{}: {}", who, claim());
  if (const std::string looked = looked_text(); !looked.empty()) text += (has_limits ? "; " : ": ") + looked;
  text += fmt::format(": {}{}", name(state), is_allowed ? ", which is allowed" : "");
  return reason.empty() ? text : text + ": " + reason;
}

namespace {

void require_match(const std::string& level, const std::string& pattern, const std::vector<Name>& families) {
  const AskedLevel one{level, level, {}, false, {pattern}};
  std::vector<std::string_view> names;
  for (const std::string& family : families) {
    if (one.is_about(family)) return;
    names.push_back(family);
  }
  throw Error(fmt::format("requirement '{}': no family of this run matches '{}'{} {}", level, pattern,
                          did_you_mean(pattern, names),
                          names_alike("families", pattern, names, "axiscert families --predicate ID")));
}

}  // namespace

const GateLevel& level_of(const AskedLevel& asked) { return *find_level(asked.name); }

AskedLevel parse_level(const std::string& text) {
  constexpr std::string_view in = " in ";
  const std::size_t of_families = (text + ' ').find(in);
  const std::string level_text = text.substr(0, of_families);
  AskedLevel asked{text, level_text.substr(0, level_text.find('='))};
  asked.has_argument = asked.name.size() != level_text.size();
  if (asked.has_argument) asked.argument = level_text.substr(asked.name.size() + 1);
  if (of_families != text.npos) {
    std::istringstream patterns(text.substr(std::min(of_families + in.size(), text.size())));
    for (std::string pattern; std::getline(patterns >> std::ws, pattern, ',');) asked.families.push_back(pattern);
    if (asked.families.empty())
      throw Error(fmt::format("requirement '{}': name families after `in`, as in `exact in scene-*,far`", text));
  }
  const GateLevel* level = find_level(asked.name);
  if (level == nullptr) {
    throw Error(fmt::format("unknown requirement '{}'{} {}", text, did_you_mean(asked.name, gate_level_names()),
                            names_alike("levels", asked.name, usages(), "axiscert run --help")));
  }
  const std::string usage = level->usage;
  const bool takes_one = usage.find('=') != usage.npos, has_to = takes_one && usage.find('[') == usage.npos;
  if (asked.has_argument ? !takes_one : has_to)
    throw Error(fmt::format("requirement '{}': it is written {}", text, usage));
  if (!asked.families.empty() && level->asks_itself)
    throw Error(fmt::format("requirement '{}': {} looks at queries of its own, not at families; leave out `in {}`",
                            text, asked.name, fmt::join(asked.families, ",")));
  level->sentence(asked);  // which refuses a wrong argument
  return asked;
}

std::string sentence_of(const AskedLevel& asked) {
  return level_of(asked).sentence(asked) +
         "; no finding, and an answer to every query within its limits, which may be to decline where the kernel "
         "declares it";
}

std::string levels_help() {
  std::string text;
  for (const GateLevel* level : gate_levels())
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", level->usage, level->meaning);
  return text;
}

Requirements requirements_of(const PlanRecord& plan) {
  Requirements required;
  for (const std::string& level : plan.require.levels) {
    required.levels.push_back(parse_level(level));
    for (const std::string& pattern : required.levels.back().families) require_match(level, pattern, plan.families);
  }
  for (const std::string& name : plan.allow_unchecked.value_or(std::vector<LevelText>())) {
    const bool is_required = std::any_of(required.levels.begin(), required.levels.end(), [&](const AskedLevel& asked) {
      return asked.text == name || asked.name == name;
    });
    if (!is_required)
      throw Error(fmt::format("'{}' may be left unchecked, but is not required: give it to --require too", name));
    required.allowed.push_back(name);
  }
  return required;
}

std::vector<std::string> yardsticks_of(const PlanRecord& plan) { return yardsticks(requirements_of(plan).levels); }

std::vector<LevelOutcome> outcomes_of(const Record& record) { return outcomes(record, requirements_of(record.plan)); }

std::vector<LevelOutcome> outcomes_at(const Record& record, const std::string& level) {
  return outcomes(record, {{parse_level(level)}, {}});
}

const LevelOutcome* worst_of(const std::vector<LevelOutcome>& outcomes, const KernelRecord& kernel) {
  const auto badness = [](const LevelOutcome& outcome) {
    if (outcome.state == LevelState::not_checked) return outcome.is_allowed ? 1 : 2;
    return outcome.state == LevelState::met ? 0 : 3;
  };
  const LevelOutcome* worst = nullptr;
  for (const LevelOutcome& outcome : outcomes) {
    if (outcome.is_of(kernel) && (worst == nullptr || badness(outcome) > badness(*worst))) worst = &outcome;
  }
  return worst;
}

std::string state_text(const LevelOutcome* worst) {
  if (worst == nullptr) return "none given";
  return fmt::format("{}{}", name(worst->state), worst->is_allowed ? ", which is allowed" : "");
}

bool pass(const std::vector<LevelOutcome>& outcomes) {
  return std::all_of(outcomes.begin(), outcomes.end(), [](const LevelOutcome& outcome) { return outcome.passes(); });
}

std::vector<Failure> failures_of(const std::vector<LevelOutcome>& outcomes) {
  std::vector<Failure> all;
  for (const LevelOutcome& outcome : outcomes) {
    for (const Failure& failure : outcome.failures) {
      const bool is_known =
          std::any_of(all.begin(), all.end(), [&](const Failure& other) { return other.text() == failure.text(); });
      if (!is_known) all.push_back(failure);
    }
  }
  return all;
}

std::vector<Failure> unmet(const Record& record, const std::string& level) {
  return failures_of(outcomes_at(record, level));
}

FirstLevels first_levels(const Record& record) {
  if (!requirements_of(record.plan).levels.empty()) {
    FirstLevels first{true, "", outcomes_of(record)};
    first.lead = pass(first.outcomes) ? "What was required is met." : "What was required is not met.";
    return first;
  }
  FirstLevels first{false, "Nothing was required. ", {}};
  for (const GateLevel* level : gate_levels()) {
    if (level->advice == nullptr) continue;
    first.lead += fmt::format("Advised: --require {} {}.", level->name(), level->advice);
    for (LevelOutcome& outcome : outcomes_at(record, std::string(level->name())))
      first.outcomes.push_back(std::move(outcome));
  }
  return first;
}

std::string reason_text(const LevelOutcome& outcome) {
  if (outcome.failures.empty()) return outcome.reason;
  const Failure& first = outcome.failures.front();
  const std::size_t more = outcome.failures.size() - 1;
  return (first.family.empty() ? first.what
                               : fmt::format("{}: {}: {}", first.family, first.what, thousands(first.count))) +
         (more == 0 ? "" : fmt::format("; and {} more", thousands(more)));
}

}  // namespace axiscert
