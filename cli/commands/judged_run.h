// Carries out, judges and reports a plan: what `run` and `judge` do once they know their plan.
#pragma once

#include <optional>
#include <string>

#include "cli/commands/run_output.h"
#include "cli/run_options.h"
#include "plans/judged_plan.h"
#include "reports/gates/ratchet.h"

namespace axiscert {
// A run that was judged, and is not reported yet.
struct JudgedRun {
  OutputFolder folder;
  std::optional<Ratchet> ratchet;
  RunFiles files;
};

// Throws Error, and HarnessFault where the oracles disagree.
JudgedRun judge_run(const Plan& plan, const OutputOptions& output, const std::string& target_asked);

// The ratchet that --ratchet names, for put_result; read, and compared with the plan, before anything runs or is
// written. Throws Error.
std::optional<Ratchet> ratchet_of(const OutputOptions& output, const Plan& plan);

// run_files, with its progress on standard error.
RunFiles shown_run_files(const Plan& plan, const CampaignResult& result, const OutputOptions& output,
                         const std::string& target_asked, std::chrono::system_clock::time_point started,
                         std::optional<RunScale> scale = {});

// Writes the run's folder and prints its summary; returns an ExitCode.
int put_result(JudgedRun run, const OutputOptions& output);

}  // namespace axiscert
