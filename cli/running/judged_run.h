// A plan carried out, judged and reported: what `run` and `judge` do once they know their plan.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "cli/options/run_options.h"
#include "cli/running/run_output.h"
#include "reports/gates/ratchet.h"

namespace axiscert {

// Writes the run's folder and prints its summary; returns an ExitCode. Throws Error, and HarnessFault where the oracles
// disagree.
int judged_run(const Plan& plan, const OutputOptions& output, const std::string& target_asked);

// What --ratchet names, for put_result; read, and held against the plan, before anything runs or is written. Throws
// Error.
std::optional<Ratchet> ratchet_of(const OutputOptions& output, const Plan& plan);

// The second half of it, of a result that is there: record, reports, summary. `scale` is what run.json says of ranks
// and journal, or null.
int put_result(const OutputFolder& folder, const Plan& plan, const CampaignResult& result, const OutputOptions& output,
               const std::optional<Ratchet>& ratchet, const std::string& target_asked,
               std::chrono::system_clock::time_point started, const Json& scale = nullptr);

// What to throw where oracles disagreed: the query is in the folder then.
HarnessFault saved(const OutputFolder& folder, const OracleDisagreement& disagreement);

}  // namespace axiscert
