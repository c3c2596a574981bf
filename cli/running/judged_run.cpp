#include "cli/running/judged_run.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>

#include "cli/commands.h"
#include "cli/progress_line.h"
#include "cli/running/run_output.h"
#include "cli/running/shrunk.h"
#include "cli/running/terminal.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/parts/stretch.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"
#include "reports/gates/ratchet.h"
#include "fuzz/confirm/plan.h"
#include "reports/formats/render.h"
#include "reports/gates/requirement.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

constexpr const char* shrunk_file = "witnesses-shrunk.jsonl";

// Prints what is worse and what is better; returns whether the ratchet is met.
bool holds(const RatchetOutcome& outcome, bool quiet) {
  for (const std::string& better : outcome.better) {
    if (!quiet) fmt::print("{}\n", coloured("better: " + better, TextColour::green));
  }
  for (const RatchetFailure& failure : outcome.failures) fmt::print(stderr, "axiscert: --ratchet: {}\n", failure.text);
  return outcome.failures.empty();
}

}  // namespace

std::optional<Ratchet> ratchet_of(const OutputOptions& output, const Plan& plan) {
  if (output.ratchet.empty()) return std::nullopt;
  Ratchet ratchet = read_ratchet(output.ratchet);
  std::error_code none;
  if (std::filesystem::equivalent(output.ratchet, std::filesystem::path(output.out) / "ratchet.txt", none)) {
    throw Error(fmt::format("--ratchet {}: the run would overwrite it; keep the reviewed file outside of --out {}",
                            output.ratchet, output.out));
  }
  require_plan(ratchet, plan_json(plan, planned(plan), output.require));
  return ratchet;
}

HarnessFault saved(const OutputFolder& folder, const OracleDisagreement& disagreement) {
  return HarnessFault(fmt::format("{}; the query is saved in {}", disagreement.what(), folder.save(disagreement)));
}

int judged_run(const Plan& plan, const OutputOptions& output, const std::string& target_asked) {
  const std::optional<Ratchet> ratchet = ratchet_of(output, plan);
  const OutputFolder folder(output.out);
  for (const std::string& target : targets_of(plan)) require_uncontracted(target);

  const std::atomic<bool>& interrupted = watch_for_interrupts();
  const auto started = std::chrono::system_clock::now();
  CampaignResult result;
  try {
    ProgressLine progress("judging", output.quiet);
    result = run_campaign(plan, interrupted, progress.report());
  } catch (const OracleDisagreement& disagreement) {
    throw saved(folder, disagreement);
  }
  if (plan.planted != FilterFault::none) {
    throw HarnessFault(
        fmt::format("--plant {}: the cross-checks did not find it in this run", filter_fault_names[plan.planted]));
  }
  return put_result(folder, plan, result, output, ratchet, target_asked, started);
}

int put_result(const OutputFolder& folder, const Plan& plan, const CampaignResult& result, const OutputOptions& output,
               const std::optional<Ratchet>& ratchet, const std::string& target_asked,
               std::chrono::system_clock::time_point started, const Json& scale) {
  const double seconds = std::chrono::duration<double>(std::chrono::system_clock::now() - started).count();
  std::optional<ProgressLine> progress(std::in_place, "judging", output.quiet);
  progress->stage("the witnesses are confirmed");
  const Json record = record_of(plan, result, output.require);
  std::optional<RatchetOutcome> held;
  if (ratchet && result.complete)
    held = hold_against(*ratchet, record, iso_time(std::chrono::system_clock::now()).substr(0, 10));
  // These files may be left from an earlier run in the same folder.
  for (const char* file : {ratchet_outcome_file, shrunk_file}) folder.remove(file);
  folder.write("record.json", record);
  if (held) folder.write(ratchet_outcome_file, outcome_json(*ratchet, *held));
  Json info = run_info(plan, result, target_asked, iso_time(started), seconds);
  if (!scale.is_null()) info["scale"] = scale;
  folder.write("run.json", info);
  if (output.shrink != 0 && result.complete)
    folder.write_text(shrunk_file, shrunk_witnesses(record, plan.target, output.shrink, progress->report()));
  progress->stage("the reports are written");
  render_reports(output.out);
  progress.reset();  // before the summary

  if (!output.quiet) fmt::print("{}{}/report.html\n", summary_text(record, seconds), output.out);
  if (!result.complete) return exit_interrupted;
  bool is_met = true;
  if (!output.require.empty()) {
    for (const auto& failure : unmet(record, output.require)) {
      fmt::print(stderr, "axiscert: --require {}: {}\n", output.require, failure.text());
      is_met = false;
    }
  }
  if (held && !holds(*held, output.quiet)) is_met = false;
  return is_met ? exit_done : exit_requirement_failed;
}

}  // namespace axiscert
