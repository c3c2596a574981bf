// The plan of a certificate: the same from its kernel, effort, seed and meshes, here and wherever it is checked.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/options/plan_file.h"

namespace axiscert {

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
