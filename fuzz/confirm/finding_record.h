// Findings, faults of somebody else's kernel other than wrong answers, as the record has them.
#pragma once

#include "fuzz/confirm/record.h"

namespace axiscert {

// Throws Error with the findings of loading it, if a kernel exists in no precision.
void require_loaded(const Kernel& kernel);

// Appends the findings of loading the kernel, which belong to no precision, family or query.
void put_loading_findings(std::vector<FindingRecord>& findings, const Kernel& kernel);
// Appends the findings on one source, one entry a kind, with the first query that showed it.
void put_findings(std::vector<FindingRecord>& findings, const Kernel& kernel, const SeededSource& of,
                  const Tally& tally);

}  // namespace axiscert
