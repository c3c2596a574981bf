// The sections of report.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fuzz/record/record.h"
#include "reports/gates/requirement.h"

namespace axiscert {
// On why kernels are wrong, by what the exact answers say: one sentence each. Empty where no cause was looked for or
// nothing is wrong.
std::string causes_section(const Record& record);

// On why kernels are wrong whose links do not say it. Empty where no kernel of the record has a wrong verdict in a
// class of input.
std::string classes_section(const Record& record);

// On how deep wrong verdicts are. Empty where nothing is wrong, and for a predicate without depths.
std::string depths_section(const Record& record);

// On what kernels say beside their verdicts. Empty for a predicate without measures, and where there is nothing to say.
std::string contact_section(const Record& record);

// What the report begins with: the levels, the worst wrong verdict, and each kernel in a few sentences.
std::string answer_section(const Record& record);

// On what was required, and where that is not met. Empty where nothing is required.
std::string requirements_section(const Record& record, const std::vector<LevelOutcome>& outcomes);

// The axes or the comparisons of each kernel over all families, those with a flip first. `totals`: all_families() of
// the record's kernels, in their order.
std::string axes_section(const Record& record, const std::vector<std::optional<FamilyRecord>>& totals);
std::string comparisons_section(const Record& record, const std::vector<std::optional<FamilyRecord>>& totals);

}  // namespace axiscert
