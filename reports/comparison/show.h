// The presentation of a comparison, for people and for programs.
#pragma once

#include <string>

#include "reports/comparison/compare.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// The two records, and the paths of their folders as they were given, in whatever bytes.
struct ComparedRuns {
  const Record& before;
  const Record& after;
  std::string before_name, after_name;
};

// The first line: "worse: 1 new, 2 worse", "no change" or "better: ..."; with what was not compared first where nothing
// is worse: "NOT COMPARED: 26 of 27 families (general, ...): is only in OLD; the rest: no change".
std::string answer(const RunComparison& comparison);

// For the terminal (instrument_text) and for a page (instrument_page).
InstrumentReport comparison_report(const ComparedRuns& runs, const RunComparison& comparison);
// For a pull request: at most 1 MiB, with a statement of what was left out.
std::string comparison_markdown(const ComparedRuns& runs, const RunComparison& comparison);
// A ComparisonData. Cells that are zero in both are counted, not listed.
Json comparison_json(const ComparedRuns& runs, const RunComparison& comparison);

}  // namespace axiscert
