#include "cli/commands/judged_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>

#include "cli/commands.h"
#include "cli/commands/run_output.h"
#include "cli/ending.h"
#include "cli/progress_line.h"
#include "fuzz/text/file_bytes.h"
#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "plans/notices.h"
#include "plans/shrink_query.h"
#include "reports/formats/format.h"
#include "reports/gates/ratchet.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// Prints what came of each level: what is met, with what that says, on standard output; the rest on standard error.
// Returns whether all pass.
bool print_outcomes(const std::vector<LevelOutcome>& outcomes, bool quiet) {
  for (const LevelOutcome& outcome : outcomes) {
    if (outcome.passes()) {
      const bool is_met = outcome.state == LevelState::met;
      if (!quiet) fmt::print("{}\n", coloured(outcome.text(), is_met ? TextColour::green : TextColour::yellow));
      if (!quiet && is_met) fmt::print("  covers {}\n  leaves out {}\n", outcome.covers, outcome.leaves_out);
      continue;
    }
    for (const Failure& failure : outcome.failures) {
      fmt::print(stderr, "axiscert: --require {}: {}\n", outcome.asked.text, failure.text());
    }
    fmt::print(stderr, "axiscert: --require: {}\n", outcome.text());
  }
  return pass(outcomes);
}

// The same in a line for each kernel and outcome.
bool print_brief_outcomes(const std::vector<LevelOutcome>& outcomes, bool quiet) {
  const BriefOutcomes brief = brief_outcomes(outcomes);
  for (const std::string& line : brief.passing) {
    if (!quiet) fmt::print("{}\n", line);
  }
  for (const std::string& line : brief.failing) fmt::print(stderr, "axiscert: --require: {}\n", line);
  return pass(outcomes);
}

// Lines of one kind that are printed; ratchet.json in the run's folder has all of them.
constexpr std::size_t most_lines = 40;

// Prints what is worse, the worst first, and what is better; returns whether the ratchet is met. `is_judged`: the whole
// plan; no ratchet makes another run pass.
bool print_ratchet_outcome(const RatchetOutcome& outcome, const OutputOptions& output, bool is_quiet, bool is_judged) {
  const auto more = [&](std::size_t all) {
    return all <= most_lines ? ""
                             : fmt::format("{} more, in {}/{}", all - most_lines, output.out, ratchet_outcome_file);
  };
  if (!is_quiet) {
    for (const std::string& changed : outcome.changed)
      fmt::print("changed since the ratchet was written: {}\n", changed);
    for (std::size_t i = 0; i < std::min(most_lines, outcome.better.size()); ++i)
      fmt::print("{}\n", coloured("better: " + outcome.better[i], TextColour::green));
    if (const std::string rest = more(outcome.better.size()); !rest.empty()) fmt::print("better: {}\n", rest);
    if (!outcome.better.empty())
      fmt::print("{}/ratchet.txt has what is accepted with the figures of now\n", output.out);
  }
  for (std::size_t i = 0; i < std::min(most_lines, outcome.failures.size()); ++i)
    fmt::print(stderr, "axiscert: --ratchet: {}\n", outcome.failures[i].text);
  if (const std::string rest = more(outcome.failures.size()); !rest.empty())
    fmt::print(stderr, "axiscert: --ratchet: {}\n", rest);
  if (!outcome.failures.empty()) {
    fmt::print(stderr, "axiscert: {} is not met; {}\n", output.ratchet,
               is_judged ? fmt::format("{}/ratchet.txt would accept this run, once its accept: lines are filled in",
                                       output.out)
                         : "no ratchet accepts a run in which something is NOT JUDGED");
  }
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
  // Where no kernel could be loaded, there is nothing to hold, and the run is no pass.
  if (plan.questions.precisions.empty()) return std::nullopt;
  require_plan(ratchet, plan_record(plan, output.required));
  return ratchet;
}

JudgedRun judge_run(const Plan& plan, const OutputOptions& output, const std::string& target_asked) {
  source_places(plan.answerers.kernels, output.sources);  // refuses what cannot be one, before anything runs
  std::optional<Ratchet> ratchet = ratchet_of(output, plan);
  OutputFolder folder(output.out);
  keep_nothing(plan.answerers.replies ? "replies are judged in one go"
                                      : "a run without --plan keeps no journal to go on from");
  if (!plan.answerers.replies) print_first_look(plan.answerers.kernels);

  const std::atomic<bool>& interrupted = watch_for_interrupts();
  const auto started = std::chrono::system_clock::now();
  const CampaignResult result = [&] {
    ProgressLine progress("judging", output.quiet);
    return judge_plan(plan, interrupted, progress.report(), &folder);
  }();
  return {std::move(folder), std::move(ratchet), shown_run_files(plan, result, output, target_asked, started)};
}

RunFiles shown_run_files(const Plan& plan, const CampaignResult& result, const OutputOptions& output,
                         const std::string& target_asked, std::chrono::system_clock::time_point started,
                         std::optional<RunScale> scale) {
  ProgressLine progress("judging", output.quiet);
  return run_files(
      plan, result, output, target_asked, started, [&](std::string_view stage) { progress.begin_stage(stage); },
      std::move(scale));
}

int put_result(JudgedRun run, const OutputOptions& output) {
  const OutputFolder& folder = run.folder;
  auto& [record, info] = run.files;
  const bool is_complete = record.complete;
  std::optional<RatchetOutcome> held;
  if (run.ratchet && is_complete)
    held = hold_against(*run.ratchet, record, iso_time(std::chrono::system_clock::now()).substr(0, 10));
  const std::vector<LevelOutcome> outcomes = write_run(folder, run.files);
  if (held) folder.write(ratchet_outcome_file, json_of(*held));
  std::optional<ProgressLine> progress(std::in_place, "judging", output.quiet);
  if (output.shrink != 0 && is_complete)
    folder.write_text(shrunk_file, shrunk_witnesses(record, info.target.dispatched, output.shrink, progress->report()));
  progress->begin_stage("the reports are written");
  try {
    render_reports(output.out);
  } catch (const Unwritable&) {
    if (is_complete)
      keep_work(fmt::format("{}/record.json is whole", output.out), "axiscert report " + shell_word(output.out));
    throw;
  }
  progress.reset();  // before the summary

  // First, and where standard output goes elsewhere on standard error too.
  const std::vector<std::string> nothing = output.has_summary ? unjudged(record) : std::vector<std::string>();
  const bool is_quiet = output.quiet || output.format != "text";  // nothing else is on standard output then
  const bool is_on_one_screen = !is_quiet && isatty(STDOUT_FILENO) != 0 && isatty(STDERR_FILENO) != 0;
  for (const std::string& sentence : nothing) {
    if (!is_on_one_screen) fmt::print(stderr, "axiscert: {}\n", sentence);
    if (!is_quiet) fmt::print("{}\n", coloured(sentence, TextColour::red));
  }
  if (!is_quiet && output.has_summary) {
    const bool is_brief = output.is_brief && is_complete;
    fmt::print("{}{}/report.html\n", is_brief ? brief_text(record) : summary_text(record, info.seconds), output.out);
  }
  if (!output.quiet && output.format == "csv") fmt::print("{}", read_bytes(output.out + "/" + record_csv_file));
  bool is_met = nothing.empty();
  if (!(output.is_brief ? print_brief_outcomes : print_outcomes)(outcomes, is_quiet)) is_met = false;
  if (held && !print_ratchet_outcome(*held, output, is_quiet, nothing.empty())) is_met = false;
  if (run.ratchet && !held)
    fmt::print(stderr, "axiscert: --ratchet {}: NOT CHECKED: {}\n", output.ratchet, interrupted_text(record));
  if (!is_complete) return interrupted_code();
  if (output.is_brief && !is_quiet) {
    fmt::print("{}\n",
               is_met ? coloured("verdict: met", TextColour::green) : coloured("verdict: not met", TextColour::red));
  }
  return is_met ? exit_done : exit_requirement_failed;
}

}  // namespace axiscert
