#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "cli/commands.h"
#include "cli/progress_line.h"
#include "cli/running/terminal.h"
#include "kernel/base/error.h"
#include "kernel/base/utf8.h"
#include "kernel/kernel.h"
#include "reports/comparison/compare.h"
#include "reports/comparison/show.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

struct CompareOptions {
  std::string before, after, format = "text", out;
  std::vector<std::string> kernels;  // those that may be loaded
  bool no_replay = false, quiet = false;
};

// The kernels that the user names. Each must be in OLD, since naming another would have no effect.
std::set<std::string> trusted_kernels(const CompareOptions& options, const Json& record) {
  const auto known = record["plan"]["kernels"].get<std::vector<std::string>>();
  for (const std::string& id : options.kernels) {
    if (std::find(known.begin(), known.end(), id) == known.end())
      throw Error(fmt::format("--kernel {}: not in {}, which has: {}", id, options.before, fmt::join(known, ", ")));
  }
  return {options.kernels.begin(), options.kernels.end()};
}

int compare(const CompareOptions& options) {
  const Run before = read_run(options.before), after = read_run(options.after);
  require_same_test(before.record, after.record, as_utf8(options.before), as_utf8(options.after));
  const std::set<std::string> trusted = trusted_kernels(options, before.record);
  std::optional<ProgressLine> progress(std::in_place, "compare", options.quiet);
  progress->stage("the witnesses are evaluated again");
  std::vector<Replayed> replayed;
  if (!options.no_replay) replayed = replay_witnesses(before.record, resolve_target("auto"), trusted);
  const RunComparison comparison = compare_records(before.record, after.record, std::move(replayed));
  progress.reset();
  const ComparedRuns runs{before.record, after.record, options.before, options.after};
  const InstrumentReport report = comparison_report(runs, comparison);
  const std::string markdown = comparison_markdown(runs, comparison);
  if (!options.out.empty()) {
    make_folder(options.out);
    write_files(options.out, {{"compare.json", report.data.dump(1) + "\n"},
                              {"compare.md", markdown},
                              {"compare.html", instrument_page(report)}});
  }
  const std::size_t alarms = comparison.alarms();
  if (!options.quiet) {
    if (options.format == "json") fmt::print("{}\n", report.data.dump(1));
    else if (options.format == "markdown") fmt::print("{}", markdown);
    else {
      // The first line is the answer.
      const std::string text = instrument_text(report);
      const std::size_t end = text.find('\n') + 1;
      fmt::print("{}{}", coloured(text.substr(0, end), alarms != 0 ? TextColour::red : TextColour::green),
                 text.substr(end));
    }
  }
  return alarms == 0 ? exit_done : exit_requirement_failed;
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "compare", "Compare two runs: what is new, worse, better, fixed; exit 1 where anything is new or worse");
  auto options = std::make_shared<CompareOptions>();
  command->add_option("OLD", options->before, "the folder of the earlier run")->required();
  command->add_option("NEW", options->after, "the folder of the later run")->required();
  command->add_option("--format", options->format, "format of the output: text, json or markdown")
      ->check(CLI::IsMember({"text", "json", "markdown"}))
      ->capture_default_str();
  command->add_option("--out", options->out, "folder for compare.md, compare.json and compare.html");
  command
      ->add_option("--kernel", options->kernels,
                   "plugin:PATH.so of OLD, which is loaded to evaluate the witnesses of OLD again; no plug-in that a "
                   "record names is loaded without it; repeatable")
      ->allow_extra_args(false);
  command->add_flag("--no-replay", options->no_replay, "do not evaluate the witnesses of OLD again");
  add_plugin_seconds(*command);
  add_progress(*command);
  command->add_flag("--quiet", options->quiet, "print only errors: the exit code is the answer");
  command->callback([&action, options] { action = [options] { return compare(*options); }; });
}

}  // namespace axiscert
