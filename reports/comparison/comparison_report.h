// What `axiscert compare` prints: the struct for programs, and the same for people.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/comparison/compare.h"
#include "reports/instrument/instrument.h"

namespace axiscert {
struct ComparedRunData {
  std::string folder, axiscert;
  WholeNumber seed;
  bool complete = false;

  AXISCERT_FIELDS(ComparedRunData, AXISCERT_FIELD(folder, "The folder as given."),
                  AXISCERT_FIELD(axiscert, "The version that ran it."),
                  AXISCERT_FIELD(seed, "The seed of its plan; 64 bits."),
                  AXISCERT_FIELD(complete, "False where it was interrupted."))
};

struct ComparedCellData {
  std::string fingerprint, kernel, precision, family, place, figure;
  Change change = Change::unchanged;
  Json before, after;
  std::uint64_t before_queries = 0, after_queries = 0;
  bool same_queries = false;
  std::optional<double> p, p_corrected;
  std::vector<std::string> witnesses;

  AXISCERT_FIELDS(
      ComparedCellData,
      AXISCERT_FIELD(fingerprint, "A hash of kernel, precision, family and cell: the same in every run."),
      AXISCERT_FIELD(kernel, "Its id; plugin/NAME where it has another id in each run."),
      AXISCERT_FIELD(precision, "Empty for a finding made in loading."),
      AXISCERT_FIELD(family, "Empty for a finding made in loading."),
      AXISCERT_FIELD(place, "verdict, a comparison, finding, or a member of the record's `contacts`."),
      AXISCERT_FIELD(figure, "The record's member, or the kind of a finding."),
      AXISCERT_FIELD(change, "How NEW differs from OLD."),
      field(&Of::before, {"old", "A count, or a maximum; the text of a number that binary64 cannot hold."}),
      field(&Of::after, {"new", "The same for NEW."}),
      field(&Of::before_queries,
            {"old_queries",
             "The number of queries among which OLD counted it, for time the contacts that were found, for feature "
             "those with one; 0 for maxima and findings."}),
      field(&Of::after_queries, {"new_queries", "The same for NEW."}),
      AXISCERT_FIELD(same_queries,
                     "Whether both were counted over the same queries: figures are then compared as they are."),
      AXISCERT_FIELD(p, "Fisher's probability, two-sided; null where nothing was tested."),
      AXISCERT_FIELD(p_corrected,
                     "The same after Holm's correction. An undeclared decline, an answer invalid or none that OLD does "
                     "not have is new whatever it is."),
      AXISCERT_FIELD(witnesses, "Ids of the witnesses in NEW that show it, where it is new or worse.", "witnesses"))
};

struct ComparisonData {
  FormatName<ComparisonData> schema;
  ComparedRunData before, after;
  std::string answer;
  bool passes = false;
  std::uint64_t alarms = 0;
  double family_wise_error = 0;
  std::uint64_t tested = 0, compared = 0;
  std::vector<ComparedPromise> promises;
  std::vector<ComparedKernel> kernels;
  EnumArray<Change, std::uint64_t> counts{};
  std::vector<ComparedCellData> cells;
  std::uint64_t wrong_nowhere = 0, not_looked_at = 0;
  std::vector<ReplayedQuery> replayed;
  std::vector<NotCompared> not_compared;
  std::vector<WitnessRecord> new_witnesses;

  static constexpr std::string_view format = "axiscert-comparison/4", title = "axiscert comparison";
  static constexpr std::string_view about = "The result of `axiscert compare OLD NEW`.";
  AXISCERT_FIELDS(
      ComparisonData, AXISCERT_FIELD(schema, "The format of this file."),
      field(&Of::before, {"old", "The earlier run."}), field(&Of::after, {"new", "The later run."}),
      AXISCERT_FIELD(answer, "The answer in one line."),
      AXISCERT_FIELD(
          passes, "Whether the exit code is 0: no alarm, something was compared, and nothing of not_compared fails."),
      AXISCERT_FIELD(alarms,
                     "Cells that are new or worse, kernels that promise less in a precision, and witnesses of OLD that "
                     "were right and are wrong now, or that are no longer promised."),
      AXISCERT_FIELD(family_wise_error,
                     "Upper bound on the probability of any alarm between runs that differ by chance alone."),
      AXISCERT_FIELD(tested, "Cells over different queries, which Holm's correction covers.", "cells"),
      AXISCERT_FIELD(
          compared,
          "Counts over promised queries of both runs, which were set against each other. Exit 1 where there are none.",
          "cells"),
      AXISCERT_FIELD(promises,
                     "Kernels whose promise is another in NEW: its limits, policies, answer to touching queries, leave "
                     "to decline, or existence in a precision."),
      AXISCERT_FIELD(kernels, "The kernels of both plans."), AXISCERT_FIELD(counts, "Cells by change.", "cells"),
      AXISCERT_FIELD(cells, "Every cell that is not zero in both."),
      AXISCERT_FIELD(wrong_nowhere, "Cells that are zero in both, where both runs have answers that could be wrong so.",
                     "cells"),
      AXISCERT_FIELD(not_looked_at, "Cells that are zero in both, where a run has no such answer.", "cells"),
      AXISCERT_FIELD(replayed, "Witnesses of OLD, evaluated again by the kernels of this build."),
      AXISCERT_FIELD(not_compared,
                     "Everything that only one run has, or that they counted over other promised queries."),
      AXISCERT_FIELD(new_witnesses, "Witnesses of NEW that show what is new or worse, as its record has them."))
};

// The presentation of a comparison, for people and for programs.

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
