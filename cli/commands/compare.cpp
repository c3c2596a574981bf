#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "cli/commands.h"
#include "cli/commands/run_output.h"
#include "cli/help.h"
#include "cli/progress_line.h"
#include "cli/shared_options.h"
#include "cli/usage.h"
#include "kernel/base/error.h"
#include "kernel/kernel.h"
#include "kernel/plugin/load.h"
#include "plans/notices.h"
#include "reports/comparison/compare.h"
#include "reports/comparison/comparison_report.h"
#include "reports/run_folder/identity.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

struct CompareOptions {
  std::string before, after, format = "text", out;
  std::vector<std::string> kernels;  // those that may be loaded
  std::vector<std::string> allowed;  // what need not be compared
  bool no_replay = false, quiet = false;
};

std::string how_given(const std::string& id) { return id.substr(0, id.find(':')); }
std::string path_of(const std::string& id) { return id.substr(id.find(':') + 1); }

// Whether two ids are of one plug-in or program, given by two spellings of one path.
bool is_same_path(const std::string& x, const std::string& y) {
  const auto normal = [](const std::string& id) { return std::filesystem::path(path_of(id)).lexically_normal(); };
  return plugin::is_given_by_file(x) && plugin::is_given_by_file(y) && how_given(x) == how_given(y) &&
         normal(x) == normal(y);
}

// The kernel of OLD that the user names: by its id, by another spelling of its path, or, loaded, by the name that it
// declares, wherever it is now. Each has to be in OLD, since naming another would have no effect.
std::string named_kernel(const std::string& given, const CompareOptions& options, const Record& record) {
  const std::vector<std::string> known(record.plan.kernels.begin(), record.plan.kernels.end());
  if (std::find(known.begin(), known.end(), given) != known.end()) return given;
  for (const std::string& id : known) {
    if (is_same_path(id, given)) return id;
  }
  std::string declares;
  if (plugin::is_given_by_file(given) && std::filesystem::is_regular_file(path_of(given))) {
    declares = find_kernel(given).declared_name;
    for (const auto& [id, identity] : identities_of(record)) {
      if (!declares.empty() && identity == fmt::format("{}/{}", how_given(given), declares)) return id;
    }
  }
  throw Error(fmt::format(
      "--kernel {}: not in {}, which has: {}{}", given, options.before,
      fmt::join(most_alike_first(given, {known.begin(), known.end()}), ", "),
      declares.empty() ? "" : fmt::format("; it declares the name '{}', which none of them does", declares)));
}

TrustedPlugins trusted_kernels(const CompareOptions& options, const Record& record) {
  TrustedPlugins trusted;
  for (const std::string& given : options.kernels) {
    trusted[named_kernel(given, options, record)] = given;
    print_first_look(find_kernel(given));
  }
  return trusted;
}

int compare(const CompareOptions& options) {
  const Run before = read_run(options.before), after = read_run(options.after);
  require_same_predicate(before.record, after.record, options.before, options.after);
  const TrustedPlugins trusted = trusted_kernels(options, before.record);
  std::optional<ProgressLine> progress(std::in_place, "compare", options.quiet);
  progress->begin_stage("the witnesses are evaluated again");
  std::vector<ReplayedQuery> replayed;
  if (!options.no_replay) replayed = replay_witnesses(before.record, resolve_target("auto"), trusted);
  const RunComparison comparison = compare_records(before.record, after.record, std::move(replayed), options.allowed);
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
  if (!options.quiet) {
    if (options.format == "json") fmt::print("{}\n", report.data.dump(1));
    else if (options.format == "markdown") fmt::print("{}", markdown);
    else {
      // The first line is the answer.
      const std::string text = instrument_text(report);
      const std::size_t end = text.find('\n') + 1;
      fmt::print("{}{}", coloured(text.substr(0, end), comparison.passes() ? TextColour::green : TextColour::red),
                 text.substr(end));
    }
  }
  return comparison.passes() ? exit_done : exit_requirement_failed;
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "compare",
      "Compare two runs: what is new, worse, better, fixed; exit 1 where anything is new or worse, where a "
      "kernel promises less, or where something of OLD was not compared");
  auto options = std::make_shared<CompareOptions>();
  command->add_option("OLD", options->before, "the folder of the earlier run")->required()->check(no_kernel());
  command->add_option("NEW", options->after, "the folder of the later run")->required()->check(no_kernel());
  add_format(*command, options->format, {"json", "markdown"});
  add_out(*command, options->out, "compare.md, compare.json and compare.html");
  add_kernels(*command, options->kernels,
              "plugin:PATH.so or program:MANIFEST.json of OLD, or one that declares the same name, which is loaded "
              "to evaluate the witnesses of OLD again; none that a record names is loaded without it");
  command
      ->add_option("--allow-not-compared", options->allowed,
                   "what need not be compared: a kernel, a family, or what the table NOT COMPARED names; repeatable")
      ->allow_extra_args(false);
  command->add_flag("--no-replay", options->no_replay, "do not evaluate the witnesses of OLD again");
  add_plugin_seconds(*command);
  add_progress(*command);
  add_quiet(*command, options->quiet, "print only errors: the exit code is the answer");
  add_examples(*command, {{"What is new, worse, better, fixed?", "axiscert compare out-before out"},
                          {"The same for a pull request", "axiscert compare out-before out --format markdown"},
                          {"Ask a plug-in the witnesses of the earlier run again",
                           "axiscert compare out-before out plugin:./my_kernel.so"}});
  command->callback([&action, options] { action = [options] { return compare(*options); }; });
}

}  // namespace axiscert
