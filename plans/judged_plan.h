// A plan that is judged: the contents of a run's folder.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/progress.h"
#include "fuzz/campaign/stretch.h"
#include "fuzz/record/run_info.h"
#include "kernel/kernel.h"
#include "plans/output_folder.h"
#include "plans/run_plan.h"
#include "reports/gates/requirement.h"

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

// Is told what is under way, where that cannot say how far it is; may be empty.
using BeginStage = std::function<void(std::string_view name)>;

// Runs these stretches of a plan on its threads and hands each to `done`, in any order, from this thread; begins no
// other once `interrupted`. Throws what judging throws.
void run_stretches(const Plan& plan, const Stretches& stretches, const std::vector<std::uint64_t>& numbers,
                   const std::atomic<bool>& interrupted, const ShowProgress& show,
                   const std::function<void(const Entry&)>& done);

// The stretches that are done are kept in the folder's journal. The record is the same however often the run was ended.
inline constexpr const char* journal_file = "journal";
struct Keeping {
  bool resumes = false;  // goes on from the journal, where there is one; otherwise that is taken away
  std::string code;      // what kernels are made of that are no files: the journal is of these alone
};

// Runs the plan, on targets whose arithmetic has passed the self-check. Throws HarnessFault where it has not, where a
// planted fault was not found, or the oracles disagree: then the query is saved in `folder`, if that is given. With
// `keeping`, which takes a folder and a plan without a time limit, throws Error for a journal of another plan.
CampaignResult judge_plan(const Plan& plan, const std::atomic<bool>& interrupted, const ShowProgress& show,
                          const OutputFolder* folder, const Keeping* keeping = nullptr);

// Confirms the witnesses of a result. `scale` is run.json's entry on ranks and journal.
RunFiles run_files(const Plan& plan, const CampaignResult& result, const OutputOptions& output,
                   const std::string& target_asked, std::chrono::system_clock::time_point started,
                   const BeginStage& begin_stage, std::optional<RunScale> scale = {});

// Writes record.json and run.json, which says what came of the levels that the record requires; returns these outcomes.
// Takes away what an earlier run left there and this one does not write.
std::vector<LevelOutcome> write_run(const OutputFolder& folder, const RunFiles& run);
inline constexpr const char* shrunk_file = "witnesses-shrunk.jsonl";

// Saves the query on which oracles disagreed in the folder, and returns the exception to throw.
HarnessFault save_disagreement(const OutputFolder& folder, const OracleDisagreement& disagreement);

}  // namespace axiscert
