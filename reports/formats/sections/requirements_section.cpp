#include "reports/formats/sections/requirements_section.h"

#include <fmt/format.h>

#include "reports/wording/markdown_text.h"

namespace axiscert {
namespace {

std::string failure_line(const Failure& f) {
  if (f.family.empty()) return fmt::format("- {}: {}", plain(f.kernel), plain(f.what, 2000));
  return fmt::format("- {} {} on {}: {}: {}{}", plain(f.kernel), f.precision, plain(f.family), plain(f.what, 2000),
                     thousands(f.count), f.witness.empty() ? "" : ", witness " + plain(f.witness));
}

std::string meaning_of(const LevelOutcome& outcome) {
  switch (outcome.state) {
    case LevelState::met:
      return fmt::format("covers {}; leaves out {}", plain(outcome.covers, 2000), plain(outcome.leaves_out, 2000));
    case LevelState::not_met:
      return fmt::format("{} ways in which it falls short, below", thousands(outcome.failures.size()));
    case LevelState::not_checked:
      break;
  }
  return plain(outcome.reason, 2000);
}

}  // namespace

std::string requirements_section(const Record& record, const std::vector<LevelOutcome>& outcomes) {
  const Requirements required = requirements_of(record.plan);
  if (required.levels.empty()) return "";
  Section section("Requirements");
  for (const AskedLevel& asked : required.levels)
    section.line(fmt::format("Requirement `{}`: {}.\n", plain(asked.text), plain(sentence_of(asked), 2000)));
  section.line(pass(outcomes) ? "The gate passes.\n" : "**The gate fails**: what is not checked does not pass.\n");
  section.head({"level", "kernel", "precision", "state", "how much was looked at", "what that says"}, 6);
  for (const LevelOutcome& outcome : outcomes) {
    const std::string state(state_text(&outcome));
    section.row({plain(outcome.claim()), plain(outcome.kernel), outcome.precision,
                 outcome.passes() ? state : fmt::format("**{}**", state), outcome.looked_text(), meaning_of(outcome)});
  }
  section.line("");
  for (const Failure& failure : failures_of(outcomes)) section.line(failure_line(failure));
  return section.text();
}

}  // namespace axiscert
