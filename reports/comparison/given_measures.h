// Measures that a kernel gives in one of two runs alone.
#pragma once

#include "reports/comparison/compare.h"

namespace axiscert {

// Adds a sentence for each precision that both runs judged: to `unchecked` where OLD gave more, so that something is
// not checked any more, and to `only_new` where NEW gives more. `kernel` is in both records.
void say_given_by_one(const Json& before, const Json& after, const ComparedKernel& kernel, RunComparison& result);

}  // namespace axiscert
