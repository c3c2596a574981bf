// A plan as a file: the options that its record depends on, the plan that they lead to, and a digest over both.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plans/run_plan.h"
#include "fuzz/campaign/stretch.h"
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

// The plan of a certificate: the same from its kernel, effort, seed and meshes, here and wherever it is checked.

struct CertifiedRun {
  std::string kernel;  // its id
  std::string effort = "quick";
  std::uint64_t seed = 1;
  std::vector<std::string> meshes;
  int threads = 0;
};

// The kernel, then those that answer the same queries besides (first `published`, then `certified`, where they are of
// the kernel's predicate; of another predicate its default kernel), on every family of its predicate, the corpus where
// there is one, and the meshes. Throws Error for a kernel that could not be loaded.
PlanFile certified_plan(const CertifiedRun& run);

// A kernel of which nothing is here but what a certificate says.
struct AbsentKernel {
  const Predicate* predicate;
  std::size_t entry;
  std::vector<Precision> precisions;
  bool is_slow;  // not built in
};
// The same plan's questions, and the plan as a record has it, with the kernel that run.kernel names.
struct PlanOfAbsent {
  Questions questions;
  Json json;
};
PlanOfAbsent certified_plan_of(const CertifiedRun& run, const AbsentKernel& kernel);

}  // namespace axiscert
