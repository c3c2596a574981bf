// Runs a plan file: by one process or by the ranks of an MPI job, whole or a shard of it, with a journal of what is
// finished.
#pragma once

#include "cli/options/plan_file.h"
#include "fuzz/campaign/parts/gathered.h"
#include "fuzz/campaign/parts/journal.h"

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

// Files in the folder of a planned run.
inline constexpr const char* journal_file = "journal";
inline constexpr const char* plan_copy = "plan.json";

// The stretches that are requested.
using Selection = std::function<bool(std::uint64_t)>;

// Adds --plan and the options that go with it; options of `run` that a plan determines are refused next to it.
void add_planned_options(CLI::App& command, PlannedOptions& options);
// Uses from `run` the folder, threads, target and --exact-only. Returns an ExitCode.
int run_planned(const PlannedOptions& options, const RunOptions& run);

}  // namespace axiscert
