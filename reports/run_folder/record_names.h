// The names in a record that its test decides: clauses, comparisons, and the numbers of a query.
#pragma once

#include <optional>
#include <string>

#include "fuzz/text/json.h"
#include "kernel/test.h"

namespace axiscert {

// The first place where a record's names are not those of its plan's test, and what is wrong there: a comparison or
// clause that is missing, or one that the test does not have. `record` conforms to the schema. Throws Error where the
// plan's test does not exist.
std::optional<std::string> fault_of_names(const Json& record);

// The entry in which the numbers of a witness or finding are given: all of its groups are members. Null where there is
// no such entry.
const TestEntry* entry_of(const TestDescription& test, const Json& query);

}  // namespace axiscert
