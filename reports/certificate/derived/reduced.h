// The record that a certificate carries: its plan, the kernels with their promises, the counts of all stretches added
// up, and the findings; without witnesses, and without what no level reads.
#pragma once

#include <string>

#include "fuzz/campaign/parts/stretch.h"
#include "fuzz/record/record.h"

namespace axiscert {

// The parts of a certificate's materials that a run's record gives: "kernels", the record's entries whose families have
// only what is not counted by stretch, and "findings". The first kernel is called "kernel", as in its plan.
Json kernels_of_record(const Record& record);
Json findings_of_record(const Record& record);

// The stretches of a certificate's plan, from the numbers in it. Throws NotValid, which begins with `name`.
Stretches stretches_of(const Json& predicate, const std::string& name);
// Throws NotValid where they are not as long as `certify` makes them.
void require_usual_stretches(const Json& predicate, const std::string& name);

// The record, made of the predicate's members "kernel" and "materials", which conform to certificate.schema.json.
// Throws NotValid, which begins with `name`, for stretches that are missing, doubled or of another size, and for counts
// that contradict each other or the plan.
Record reduced_record(const Json& predicate, const std::string& name);

}  // namespace axiscert
