#include "reports/gates/first_levels.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/wording/summary.h"

namespace axiscert {

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
