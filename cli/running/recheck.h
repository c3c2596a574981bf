// `run --recheck`: a sample of what the journal says is finished, done again on another target or by another build.
#pragma once

#include "cli/running/planned_run.h"
#include "fuzz/campaign/parts/distribute.h"

namespace axiscert {

// A task of a planned run's crew: a stretch, and whether it is done again, on the other target.
constexpr Task task_of(std::uint64_t stretch, bool is_again) { return stretch * 2 + (is_again ? 1 : 0); }
constexpr std::uint64_t stretch_of(Task task) { return task / 2; }
constexpr bool is_again(Task task) { return task % 2 != 0; }

// The instruction set of the second time.
std::string recheck_target(const PlannedOptions& options, const std::string& first);

struct Rechecked {
  const Plan& plan;
  const Stretches& stretches;
  std::string journal;
  const OutputOptions& output;
  int threads;
};
// Says what was compared; throws HarnessFault where something differs.
void recheck(const PlannedOptions& options, const PlanFile& file, const Rechecked& run, Distributor& distributor);

}  // namespace axiscert
