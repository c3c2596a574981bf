// A plan as a file: the options that its record depends on, the plan that they lead to, and a digest over both.
#pragma once

#include "cli/options/run_options.h"
#include "fuzz/campaign/parts/stretch.h"
#include "fuzz/text/json.h"

namespace axiscert {

struct PlanFile {
  std::string path;          // shown in messages
  Json json;                 // the whole file
  std::string digest;        // SHA-256, 64 hex digits, of the whole file without the digest
  RunOptions options;        // as given to `axiscert plan`
  std::uint64_t units_each;  // per stretch

  std::string text() const;
};

// Makes the plan file of these options: looks up every name and reads every file. Throws Error.
PlanFile plan_file_of(const RunOptions& options, std::optional<std::uint64_t> units_each);
// Throws Error where the file is not a plan, has another version, or was changed since it was written.
PlanFile read_plan_file(const std::string& path);
// The plan of a file, as this axiscert makes it: throws Error where the two differ, for example because a mesh has
// changed. A file that is not at its path is looked for next to the plan. Target and threads are up to the caller.
Plan plan_of(const PlanFile& file);

// The first difference between two plans: "seed is 2, not 1". Empty where there is none.
std::string difference(const Json& plan, const Json& expected);

}  // namespace axiscert
