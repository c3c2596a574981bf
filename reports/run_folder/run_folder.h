// A run's folder, read and checked: the only input of a report.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "fuzz/record/record.h"
#include "fuzz/record/run_info.h"
#include "fuzz/text/json.h"
#include "kernel/predicate.h"
#include "reports/run_folder/ratchet_outcome.h"

namespace axiscert {

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

// Replaces the named files of the folder: every text is on disk before the first file changes. Throws Error.
void write_files(const std::filesystem::path& folder, const std::map<std::string, std::string>& texts);

}  // namespace axiscert
