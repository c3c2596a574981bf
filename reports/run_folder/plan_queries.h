// The queries that the figures of a record are about, as its plan tells them: equal fingerprints, equal queries.
#pragma once

#include <string>

#include "fuzz/record/plan_record.h"

namespace axiscert {

// The first 16 hex digits of the SHA-256 of a text.
std::string short_sha256(const std::string& text);

// The settings that decide over which queries a family's cell was counted: seed or file, generator, trials. Null where
// the number of queries depended on time. Equal texts mean equal queries.
Json queries_of(const PlanRecord& plan, const std::string& family, Precision precision);
// 16 hex digits over all families and tolerances of a plan, not over its kernels. Empty where the run depended on time.
std::string plan_fingerprint(const PlanRecord& plan);

}  // namespace axiscert
