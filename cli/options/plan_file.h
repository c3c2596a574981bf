// A plan as a file: the options that its record depends on, what they come to, and a digest over both.
#pragma once

#include "cli/options/run_options.h"
#include "fuzz/campaign/parts/stretch.h"
#include "fuzz/text/json.h"

namespace axiscert {

struct PlanFile {
  std::string path;          // in messages
  Json json;                 // all of it
  std::string digest;        // SHA-256, 64 hex digits, of all of it but itself
  RunOptions options;        // as they were given to `axiscert plan`
  std::uint64_t units_each;  // a stretch

  std::string text() const;
};

// Looks up every name and reads every file. Throws Error.
PlanFile plan_file_of(const RunOptions& options, std::optional<std::uint64_t> units_each);
// Throws Error where it is no plan, of another version, or was changed since it was written.
PlanFile read_plan_file(const std::string& path);
// The plan that a file tells, as this axiscert makes it: throws Error where that is another one, say because a mesh has
// changed. A file that is not where it was is looked for beside the plan. Target and threads are the caller's.
Plan plan_of(const PlanFile& file);

// The first thing in which two plans differ: "seed is 2, and not 1". Empty where nothing does.
std::string difference(const Json& plan, const Json& expected);

}  // namespace axiscert
