#include "reports/formats/sections/requirements_section.h"

#include <fmt/format.h>

#include "reports/wording/markdown_text.h"

namespace axiscert {
namespace {

std::string failure_line(const Failure& f) {
  if (f.family.empty()) return fmt::format("- {}: {}", markdown_text(f.kernel), markdown_text(f.what, 2000));
  return fmt::format("- {} {} on {}: {}: {}{}", markdown_text(f.kernel), f.precision, markdown_text(f.family),
                     markdown_text(f.what, 2000), thousands(f.count),
                     f.witness.empty() ? "" : ", witness " + markdown_text(f.witness));
}

std::string meaning_of(const LevelOutcome& outcome) {
  switch (outcome.state) {
    case LevelState::met:
      return fmt::format("covers {}; leaves out {}", markdown_text(outcome.covers, 2000),
                         markdown_text(outcome.leaves_out, 2000));
    case LevelState::not_met:
      return fmt::format("{} ways in which it falls short, below", thousands(outcome.failures.size()));
    case LevelState::not_checked:
      break;
  }
  return markdown_text(outcome.reason, 2000);
}

}  // namespace

std::string requirements_section(const Record& record, const std::vector<LevelOutcome>& outcomes) {
  const Requirements required = requirements_of(record.plan);
  if (required.levels.empty()) return "";
  Section section("Requirements");
  for (const AskedLevel& asked : required.levels)
    section.add_line(
        fmt::format("Requirement `{}`: {}.\n", markdown_text(asked.text), markdown_text(sentence_of(asked), 2000)));
  section.add_line(pass(outcomes) ? "The gate passes.\n" : "**The gate fails**: what is not checked does not pass.\n");
  section.add_head({"level", "kernel", "precision", "state", "how much was looked at", "what that says"}, 6);
  for (const LevelOutcome& outcome : outcomes) {
    const std::string state(state_text(&outcome));
    section.add_row({markdown_text(outcome.claim()), markdown_text(outcome.kernel), outcome.precision,
                     outcome.passes() ? state : fmt::format("**{}**", state), outcome.looked_text(),
                     meaning_of(outcome)});
  }
  section.add_line("");
  for (const Failure& failure : failures_of(outcomes)) section.add_line(failure_line(failure));
  return section.text();
}

}  // namespace axiscert
