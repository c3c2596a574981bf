// A run's folder, read and checked: the only input of a report.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/record.h"
#include "fuzz/record/run_info.h"
#include "fuzz/text/json_fwd.h"
#include "fuzz/text/number_text.h"
#include "fuzz/text/values.h"
#include "kernel/predicate.h"

namespace axiscert {
// Reads JSON text from a file into a value that is safe to write, compare and search recursively.

// The files that axiscert writes are some ten levels deep. nlohmann's functions on a value recurse once for each level,
// so that a file of brackets would exhaust the stack.
inline constexpr int greatest_json_depth = 100;

// Throws Json::exception where the text is not JSON, or is deeper than that.
Json parsed_json(std::string_view text);

// The struct of ratchet.json: what `axiscert run --ratchet` held a run to, and where it falls short.

// Until when, by whom and why errors are accepted.
struct Waiver {
  std::string expiry, owner, reason;

  bool operator==(const Waiver&) const = default;
  AXISCERT_FIELDS(Waiver, AXISCERT_FIELD(expiry, "The last day, YYYY-MM-DD in UTC, or never."),
                  AXISCERT_FIELD(owner, "The person or group responsible."), AXISCERT_FIELD(reason, "The reason."))
};

struct WaivedCells {
  Waiver waiver;
  std::vector<std::string> fingerprints;

  AXISCERT_FIELDS(WaivedCells, inlined(&WaivedCells::waiver),
                  AXISCERT_FIELD(fingerprints, "Those of the cells.", "cells"))
};

struct RatchetFailure {
  std::string fingerprint, kernel, precision, family, cell, text;

  AXISCERT_FIELDS(RatchetFailure,
                  AXISCERT_FIELD(fingerprint,
                                 "Of the cell, or of all cells of the kernel and precision; the same in every run."),
                  AXISCERT_FIELD(kernel, "Its id in the record; as the ratchet has it where the run did not judge it."),
                  AXISCERT_FIELD(precision, "Empty, like the family, for a finding made in loading."),
                  AXISCERT_FIELD(family,
                                 "* where the failure is about the kernel's promise in the precision, or about several "
                                 "cells: they have expired, or were not checked."),
                  AXISCERT_FIELD(cell, "verdict.false_separation, edge_ab.radius.tolerance_failures ...; or *."),
                  AXISCERT_FIELD(text, "The failure in one line, and where in the ratchet it is accepted."))
};

struct RatchetOutcome {
  FormatName<RatchetOutcome> schema;
  std::string file, plan;
  std::vector<RatchetFailure> failures;
  std::vector<std::string> better, changed;
  std::vector<WaivedCells> held;
  WholeText accepted;

  static constexpr std::string_view format = "axiscert-held/3",
                                    title = "What a run was held to, and where it falls short";
  static constexpr std::string_view about =
      "ratchet.json, which `axiscert run --ratchet` writes and the reports read. A run without --ratchet leaves none.";
  AXISCERT_FIELDS(
      RatchetOutcome, AXISCERT_FIELD(schema, "The format of this file."),
      AXISCERT_FIELD(file, "The reviewed file, as given to --ratchet."),
      AXISCERT_FIELD(plan, "The plan's fingerprint: that of the record beside it."),
      AXISCERT_FIELD(failures,
                     "Every kernel that promises less, and everything that is worse than accepted, has expired, or was "
                     "not compared or not checked, the worst first; empty where the ratchet is met."),
      AXISCERT_FIELD(better, "What is better than accepted over the same promised queries, a line each."),
      AXISCERT_FIELD(changed, "Kernels whose files have other digests than those in the ratchet."),
      AXISCERT_FIELD(held, "The cells with errors that are accepted, by waiver."),
      AXISCERT_FIELD(
          accepted,
          "The file that would accept the run, with EXPIRY, OWNER and REASON left to fill in where it is worse."))
};

// The file that a gate writes into the folder, for the reports.
inline constexpr const char* ratchet_outcome_file = "ratchet.json";

struct Run {
  Record record;
  std::optional<RunInfo> info;            // where the folder has run.json
  std::optional<RatchetOutcome> ratchet;  // where the run was compared with one
  std::filesystem::path folder;           // may hold what other commands wrote next to these files
};

// The predicate that a record's plan is about. Throws Error where there is no such predicate.
const Predicate& predicate_of(const PlanRecord& plan);
// That of the queries' numbers; null where the plan does not say it.
const LengthUnit* unit_of(const PlanRecord& plan);
// The metres of one unit of its queries: 1 where the plan does not say their unit.
double metres_of(const PlanRecord& plan);

// Whether a kernel of a record states limits of its promise: by numbers, or of motions.
bool has_limits(const KernelRecord& kernel);

// Reads a JSON file. Throws Error where it cannot be read or is not JSON.
Json read_json(const std::filesystem::path& path);
// Throws Error that names the file and says what would be right: no record, not JSON, another schema, a member that the
// schema does not allow, counts that contradict each other.
Run read_run(const std::filesystem::path& folder);
// The same for values already in memory; the names are those that an Error shows.
Record read_record(const Json& record, const std::string& name);
RunInfo read_run_info(const Json& info, const std::string& name);

// Replaces the named files of the folder: every text is on disk before the first file changes. Throws Unwritable, and
// leaves no half-written file.
void write_files(const std::filesystem::path& folder, const std::map<std::string, std::string>& texts);

}  // namespace axiscert
