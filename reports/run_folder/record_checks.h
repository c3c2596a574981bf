// Conditions on a record that its fields cannot express, on names that its predicate decides: clauses, comparisons, and
// the numbers of a query.
#pragma once

#include <optional>
#include <string>

#include "fuzz/record/kernel_record.h"
#include "fuzz/record/record.h"
#include "kernel/predicate.h"

namespace axiscert {
// The first place where a record's names are not those of its plan's predicate, and what is wrong there: a comparison
// or clause that is missing, or one that the predicate does not have. Throws Error where the plan's predicate does not
// exist.
std::optional<std::string> fault_of_names(const Record& record);

// The entry in which the numbers of a witness or finding are given: all of its groups are among them. Null where there
// is no such entry.
const PredicateEntry* entry_of(const Predicate& predicate, const WitnessRecord& query);
const PredicateEntry* entry_of(const Predicate& predicate, const FindingRecord& query);

}  // namespace axiscert
