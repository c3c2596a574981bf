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

  static constexpr auto fields(auto&& visit) {
    using Of = ComparedRunData;
    return visit(field(&Of::folder, {"folder", "The folder as given."}),
                 field(&Of::axiscert, {"axiscert", "The version that ran it."}),
                 field(&Of::seed, {"seed", "The seed of its plan; 64 bits."}),
                 field(&Of::complete, {"complete", "False where it was interrupted."}));
  }
};

struct ComparedCellData {
  std::string fingerprint, kernel, precision, family, place, figure;
  Change change = Change::unchanged;
  Json before, after;
  std::uint64_t before_queries = 0, after_queries = 0;
  bool same_queries = false;
  std::optional<double> p, p_corrected;
  std::vector<std::string> witnesses;

  static constexpr auto fields(auto&& visit) {
    using Of = ComparedCellData;
    return visit(
        field(&Of::fingerprint,
              {"fingerprint", "A hash of kernel, precision, family and cell: the same in every run."}),
        field(&Of::kernel, {"kernel", "Its id; plugin/NAME where it has another id in each run."}),
        field(&Of::precision, {"precision", "Empty for a finding made in loading."}),
        field(&Of::family, {"family", "Empty for a finding made in loading."}),
        field(&Of::place, {"place", "verdict, a comparison, finding, or a member of the record's `contacts`."}),
        field(&Of::figure, {"figure", "The record's member, or the kind of a finding."}),
        field(&Of::change, {"change", "How NEW differs from OLD."}),
        field(&Of::before, {"old", "A count, or a maximum; the text of a number that binary64 cannot hold."}),
        field(&Of::after, {"new", "The same for NEW."}),
        field(&Of::before_queries,
              {"old_queries",
               "The number of queries among which OLD counted it, for time the contacts that were found, for feature "
               "those with one; 0 for maxima and findings."}),
        field(&Of::after_queries, {"new_queries", "The same for NEW."}),
        field(&Of::same_queries,
              {"same_queries",
               "Whether both were counted over the same queries: figures are then compared as they are."}),
        field(&Of::p, {"p", "Fisher's probability, two-sided; null where nothing was tested."}),
        field(&Of::p_corrected,
              {"p_corrected",
               "The same after Holm's correction. An undeclared decline, an answer invalid or none that OLD does not "
               "have is new whatever it is."}),
        field(&Of::witnesses,
              {"witnesses", "Ids of the witnesses in NEW that show it, where it is new or worse.", "witnesses"}));
  }
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
  std::uint64_t wrong_nowhere = 0;
  std::vector<ReplayedQuery> replayed;
  std::vector<NotCompared> not_compared;
  std::vector<WitnessRecord> new_witnesses;

  static constexpr std::string_view format = "axiscert-comparison/3", title = "axiscert comparison";
  static constexpr std::string_view about = "The result of `axiscert compare OLD NEW`.";
  static constexpr auto fields(auto&& visit) {
    using Of = ComparisonData;
    return visit(
        field(&Of::schema, {"schema", "The format of this file."}), field(&Of::before, {"old", "The earlier run."}),
        field(&Of::after, {"new", "The later run."}), field(&Of::answer, {"answer", "The answer in one line."}),
        field(&Of::passes,
              {"passes",
               "Whether the exit code is 0: no alarm, something was compared, and nothing of not_compared fails."}),
        field(&Of::alarms,
              {"alarms",
               "Cells that are new or worse, kernels that promise less in a precision, and witnesses of OLD that were "
               "right and are wrong now, or that are no longer promised."}),
        field(&Of::family_wise_error,
              {"family_wise_error",
               "Upper bound on the probability of any alarm between runs that differ by chance alone."}),
        field(&Of::tested, {"tested", "Cells over different queries, which Holm's correction covers.", "cells"}),
        field(&Of::compared,
              {"compared",
               "Counts over promised queries of both runs, which were set against each other. Exit 1 where there are "
               "none.",
               "cells"}),
        field(&Of::promises,
              {"promises",
               "Kernels whose promise is another in NEW: its limits, policies, answer to touching queries, leave to "
               "decline, or existence in a precision."}),
        field(&Of::kernels, {"kernels", "The kernels of both plans."}),
        field(&Of::counts, {"counts", "Cells by change.", "cells"}),
        field(&Of::cells, {"cells", "Every cell that is not zero in both."}),
        field(&Of::wrong_nowhere, {"wrong_nowhere", "Cells that are zero in both.", "cells"}),
        field(&Of::replayed, {"replayed", "Witnesses of OLD, evaluated again by the kernels of this build."}),
        field(&Of::not_compared,
              {"not_compared", "Everything that only one run has, or that they counted over other promised queries."}),
        field(&Of::new_witnesses,
              {"new_witnesses", "Witnesses of NEW that show what is new or worse, as its record has them."}));
  }
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
