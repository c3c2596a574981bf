// The names in a record that its test decides: clauses, comparisons, and the numbers of a query.
#pragma once

#include <optional>
#include <string>

#include "fuzz/record/record.h"
#include "kernel/test.h"

namespace axiscert {

// The first place where a record's names are not those of its plan's test, and what is wrong there: a comparison or
// clause that is missing, or one that the test does not have. Throws Error where the plan's test does not exist.
std::optional<std::string> fault_of_names(const Record& record);

// The entry in which the numbers of a witness or finding are given: all of its groups are among them. Null where there
// is no such entry.
const TestEntry* entry_of(const TestDescription& test, const WitnessRecord& query);
const TestEntry* entry_of(const TestDescription& test, const FindingRecord& query);

}  // namespace axiscert
