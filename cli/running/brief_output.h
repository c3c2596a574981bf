// The output of `run --preset game`: at most ten lines of a kernel, whatever its precisions are. Results that these
// share are one line.
#pragma once

#include <string>
#include <vector>

#include "fuzz/record/record.h"
#include "reports/gates/requirement.h"

namespace axiscert {

// The first finding with the command that reproduces it, or else the cause with its shortest witness; then the
// sentences about each kernel.
std::string brief_text(const Record& record);

// The outcomes of levels: a line for each kernel and outcome, "ID: met: depth=1mm in binary64, logic". Those that pass
// and those that do not are apart.
struct BriefOutcomes {
  std::vector<std::string> passing, failing;
};
BriefOutcomes brief_outcomes(const std::vector<LevelOutcome>& outcomes);

}  // namespace axiscert
