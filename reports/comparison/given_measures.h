// Measures that a kernel gives in one of two runs alone.
#pragma once

#include "reports/comparison/compare.h"

namespace axiscert {

// Adds an entry for each precision that both runs judged: one that fails where OLD gave more, so that something is not
// checked any more, and another where NEW gives more. `kernel` is in both records.
void note_given_by_one(const Record& before, const Record& after, const ComparedKernel& kernel,
                       std::vector<NotCompared>& absent);

}  // namespace axiscert
