// What `run --preset game` prints: at most ten lines of a kernel, whatever its precisions are. What these have alike is
// one line.
#pragma once

#include <string>
#include <vector>

#include "fuzz/record/record.h"
#include "reports/gates/requirement.h"

namespace axiscert {

// The first finding with the command that reproduces it, or else the cause with its shortest witness; then the
// sentences about each kernel.
std::string brief_text(const Record& record);

// What came of the levels: a line for each kernel and outcome, "ID: met: depth=1mm in binary64, logic". What passes and
// what does not are apart.
struct BriefOutcomes {
  std::vector<std::string> passing, failing;
};
BriefOutcomes brief_outcomes(const std::vector<LevelOutcome>& outcomes);

}  // namespace axiscert
