// The level by which a mutation score is judged, as its gate.
#pragma once

#include <vector>

#include "fuzz/instruments/black_box.h"
#include "reports/gates/requirement.h"

namespace axiscert {

inline std::vector<GateFailure> mutation_gate(const Record& record) {
  std::vector<GateFailure> failures;
  for (const Failure& failure : unmet(record, level_of_mutation))
    failures.push_back({failure.kernel, failure.precision, failure.family, failure.what});
  return failures;
}

}  // namespace axiscert
