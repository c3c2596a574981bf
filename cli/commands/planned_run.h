// Runs a plan file: by one process or by the ranks of an MPI job, whole or a shard of it, with a journal of what is
// finished.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plans/judged_plan.h"
#include "plans/plan_file.h"
#include "fuzz/campaign/distribute.h"
#include "fuzz/campaign/gathered.h"
#include "fuzz/campaign/journal.h"
#include "fuzz/campaign/stretch.h"
#include "fuzz/campaign/progress.h"

namespace axiscert {
struct PlannedOptions {
  std::string plan;               // file; empty: not a planned run
  std::optional<PlanFile> made;   // the plan itself, in place of its file
  std::optional<double> seconds;  // no stretch is begun after that time; those that were are finished
  // Done by rank 0 once the run's folder is written, with what run_planned would return; it returns that instead.
  std::function<int(int code)> after;
  std::string shard;      // "I/N"
  std::string stretches;  // file with the numbers of the only stretches to run
  bool resume = false;
  double recheck = 0;  // fraction of the finished stretches
  std::optional<std::uint64_t> recheck_seed;
  std::string recheck_target, recheck_with;
};

// Files in the folder of a planned run, beside the journal.
inline constexpr const char* plan_copy = "plan.json";

inline constexpr const char* shard_file = "shard";  // "I/N", of a folder with a shard

// The stretches that are requested.
using Selection = std::function<bool(std::uint64_t)>;
// Those of the shard "I/N": every N-th stretch, beginning with the I-th. Throws Error.
Selection shard_of(const std::string& given);

// Adds --plan and the options that go with it; options of `run` that a plan determines are refused next to it.
void add_planned_options(CLI::App& command, PlannedOptions& options);
// Uses from `run` the folder, threads, target and --exact-only. Returns an ExitCode.
int run_planned(const PlannedOptions& options, const RunOptions& run);

// `run --recheck`: repeats a sample of the stretches that are finished by the journal, on another target or by another
// build.

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
