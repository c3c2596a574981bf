#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "cli/ending.h"
#include "cli/options/instrument_options.h"
#include "cli/options/run_options.h"
#include "cli/options/search_plan.h"
#include "cli/options/predicate_options.h"
#include "cli/options/shared_options.h"
#include "cli/help.h"
#include "cli/progress_line.h"
#include "cli/usage.h"
#include "cli/running/run_output.h"
#include "fuzz/search/pools.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"
#include "reports/instrument/search_report.h"

namespace axiscert {
namespace {

constexpr const char* state_file = "search.state";

std::string command_of(const SearchOptions& options, const SearchPlan& plan, const SearchResult& result) {
  std::string command = fmt::format("axiscert search --kernel {} --precision {}", plan.kernel->id, options.precision);
  for (const std::string& which : options.comparisons) command += " --comparison " + which;
  for (const std::string& what : plan.what) command += " --what " + what;
  for (const std::string& family : options.families) command += " --family " + family;
  return command + fmt::format(" --evaluations {} --seed {}", result.evaluations, options.seed);
}

int search(const SearchOptions& options) {
  const SearchPlan plan = search_plan_of(options);
  std::optional<std::string> state;
  if (options.resume) {
    if (options.out.empty()) throw Error("--resume: give the folder of the search to resume with --out");
    const std::filesystem::path stored = std::filesystem::path(options.out) / state_file;
    std::error_code ignored;
    if (!std::filesystem::exists(stored, ignored)) {
      throw Error(
          fmt::format("--resume --out {}: there is no {}; give the folder of a search that was begun with --out",
                      options.out, stored.string()));
    }
    state = read_bytes(stored.string());
    require_state_format(*state, stored.string());
  }
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);  // checked before anything runs
  const std::string kept = fmt::format("what was found is in {}", options.out);
  if (state) keep_work(kept, own_command("--resume"));
  else keep_nothing(folder ? "its state is not written yet" : "a search without --out keeps no state to go on from");
  require_uncontracted(plan.target);

  const std::atomic<bool>& interrupted = watch_for_interrupts();
  SearchResult result;
  {
    ProgressLine progress("search");
    const std::string asked_for = plan.evaluations ? fmt::format(" of {}", *plan.evaluations) : "";
    result = search(plan, state, interrupted, [&](const SearchProgress& p) {
      progress.show({p.islands, 0, 0, p.seconds}, fmt::format("; {}{} evaluations", p.evaluations, asked_for));
    });
  }
  if (folder) {
    folder->write_text(state_file, result.state);
    folder->write_text("witnesses.jsonl", search_witnesses(result));
    keep_work(kept, own_command("--resume"));
  }
  InstrumentOptions output;
  output.format = options.format;
  output.out = options.out;
  const int done = print_and_write_instrument(search_report(plan, result, command_of(options, plan, result)), output);
  if (!result.complete) return interrupted_code();
  return search_looked_at(result).decided == 0 ? exit_requirement_failed : done;
}

}  // namespace

void add_search(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("search",
                                     "Search for the worst cases of a kernel: errors of its comparisons, wrong "
                                     "verdicts, errors of numbers beside them, the scales where range fails");
  auto options = std::make_shared<SearchOptions>();
  SearchOptions& o = *options;
  add_predicate(*command, o.predicate, "predicate of the kernel",
                fmt::format("{}, or that of --kernel", default_predicate().id));
  add_kernel(*command, o.kernel, "kernel that is asked", "the first of the predicate");
  add_precision(*command, o.precision);
  command
      ->add_option("--comparison", o.comparisons, "comparison, repeatable (default: all, the verdict and the numbers)")
      ->allow_extra_args(false);
  command
      ->add_option("--what", o.what,
                   "`verdict` or the error of a number beside it (separation, normal, left, unit, point), repeatable "
                   "(default: all)")
      ->allow_extra_args(false);
  add_families(*command, o.families, "those from which a search of the predicate starts");
  auto* evaluations =
      command
          ->add_option(
              "--evaluations", o.evaluations,
              fmt::format("queries to evaluate, rounded up to whole islands (default: 2^24, of a predicate other "
                          "than {} 2^14); the short run from which it begins is not counted",
                          ids_of(predicates_with(has_filters))))
          ->check(whole_number(1, std::uint64_t{1} << 48));
  command->add_option("--time", o.seconds, "seconds to search instead")
      ->check(number_above_zero())
      ->excludes(evaluations);
  add_seed(*command, o.seed);
  command->add_flag("--resume", o.resume, "continue from the state in the folder of --out");
  add_target(*command, o.target);
  add_thread_option(*command, o.threads);
  add_plugin_seconds(*command);
  add_progress(*command);
  add_format(*command, o.format, data_formats);
  add_out(*command, o.out, "search.json, search.csv, search.html, witnesses.jsonl and the state");
  add_examples(*command, {{"A minute, to be continued", "axiscert search published --time 60 --out found"},
                          {"Continued", "axiscert search published --evaluations 1000000 --out found --resume"},
                          {"The error of one comparison",
                           "axiscert search published --comparison plane.radius --evaluations 1000"}});
  command->callback([&action, options] { action = [options] { return search(*options); }; });
}

}  // namespace axiscert
