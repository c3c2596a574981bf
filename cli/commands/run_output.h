// The output of `axiscert run`: the summary.
#pragma once

#include <string>
#include <vector>

#include "fuzz/record/record.h"
#include "plans/output_folder.h"
#include "reports/gates/requirement.h"
#include "reports/wording/summary.h"

namespace axiscert {

// Output that depends on whether a person sees it: colour.

enum class TextColour { red, yellow, green };

// Whether standard output is a terminal that shows colours, and NO_COLOR is not set to any value.
bool output_has_colour();
// The text in that colour where output_has_colour(), otherwise unchanged. A line end stays outside the colour.
std::string coloured(const std::string& text, TextColour colour);

// The findings but those of kernels that could not be loaded: unjudged() has told these.
std::vector<FindingGroup> findings_of_judged(const Record& record);

// The final output of `run`: findings first, each with the command that reproduces it, then causes and the sentences
// about each kernel and precision, then tables; in colour on a terminal.
std::string summary_text(const Record& record, double seconds);

// The output of `run --preset game`: at most ten lines of a kernel, whatever its precisions are. Results that these
// share are one line.

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
