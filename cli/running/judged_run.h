// Carries out, judges and reports a plan: what `run` and `judge` do once they know their plan.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "cli/options/run_options.h"
#include "cli/running/run_output.h"
#include "reports/gates/ratchet.h"

namespace axiscert {

// The contents of record.json and run.json.
struct RunFiles {
  Record record;
  RunInfo info;
};

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

// Confirms the witnesses of a result. `scale` is run.json's entry on ranks and journal.
RunFiles run_files(const Plan& plan, const CampaignResult& result, const OutputOptions& output,
                   const std::string& target_asked, std::chrono::system_clock::time_point started,
                   std::optional<RunScale> scale = {});

// Writes the run's folder and prints its summary; returns an ExitCode.
int put_result(JudgedRun run, const OutputOptions& output);

// Saves the query on which oracles disagreed in the folder, and returns the exception to throw.
HarnessFault save_disagreement(const OutputFolder& folder, const OracleDisagreement& disagreement);

}  // namespace axiscert
