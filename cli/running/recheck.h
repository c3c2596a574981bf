// `run --recheck`: repeats a sample of the stretches that are finished by the journal, on another target or by another
// build.
#pragma once

#include "cli/running/planned_run.h"
#include "fuzz/campaign/parts/distribute.h"

namespace axiscert {

// A task of a planned run's crew: a stretch, and whether it is repeated on the other target.
constexpr Task task_of(std::uint64_t stretch, bool is_again) { return stretch * 2 + (is_again ? 1 : 0); }
constexpr std::uint64_t stretch_of(Task task) { return task / 2; }
constexpr bool is_again(Task task) { return task % 2 != 0; }

// The instruction set of the repetition.
std::string recheck_target(const PlannedOptions& options, const std::string& first);

struct RecheckedRun {
  const std::vector<const Kernel*>& kernels;
  const RunningOptions& on;
  const Stretches& stretches;
  std::string journal;
  const OutputOptions& output;
};
// Prints what was compared; throws HarnessFault where something differs.
void recheck(const PlannedOptions& options, const PlanFile& file, const RecheckedRun& run, Distributor& distributor);

}  // namespace axiscert
