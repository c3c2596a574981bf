// Carries out, judges and reports a plan: what `run` and `judge` do once they know their plan.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/run_options.h"
#include "cli/running/run_output.h"
#include "fuzz/record/run_info.h"
#include "kernel/kernel.h"
#include "reports/gates/ratchet.h"

namespace axiscert {
// Where kernels are written, for the reports that point at a line of somebody's repository.

// run.json's "sources": by kernel id, the file and line that --source gives, or that a plug-in says of itself; a kernel
// of which neither is known is left out. `given`: the values of --source, [KERNEL=]FILE:LINE, the last one for a kernel
// counts. A path inside the present folder is made relative to it. Throws Error for a value that has no line, names a
// file that is not there, or has no kernel that it could be about.
SourcePlaces source_places(const std::vector<const Kernel*>& kernels, const std::vector<std::string>& given);

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
