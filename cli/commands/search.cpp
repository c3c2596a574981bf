#include <fmt/format.h>

#include <atomic>

#include "cli/commands/run_output.h"
#include "cli/ending.h"
#include "cli/help.h"
#include "cli/instrument_options.h"
#include "cli/progress_line.h"
#include "cli/run_options.h"
#include "cli/shared_options.h"
#include "cli/usage.h"
#include "fuzz/search/pools.h"
#include "plans/kernel_figures.h"
#include "plans/predicate_options.h"
#include "plans/search_plan.h"
#include "reports/instrument/search_report.h"

namespace axiscert {
namespace {

int search(const SearchOptions& options) {
  const SearchPlan plan = search_plan_of(options);
  const std::optional<std::string> state = search_state(options);
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);  // checked before anything runs
  const std::string kept = fmt::format("what was found is in {}", options.out);
  if (state) keep_work(kept, own_command("--resume"));
  else keep_nothing(folder ? "its state is not written yet" : "a search without --out keeps no state to go on from");

  const std::atomic<bool>& interrupted = watch_for_interrupts();
  const Searched found = [&] {
    ProgressLine progress("search");
    const std::string asked_for = plan.evaluations ? fmt::format(" of {}", *plan.evaluations) : "";
    return searched(options, plan, state, interrupted, [&](const SearchProgress& p) {
      progress.show({p.islands, 0, 0, p.seconds}, fmt::format("; {}{} evaluations", p.evaluations, asked_for));
    });
  }();
  if (folder) {
    write_search(*folder, found.result);
    keep_work(kept, own_command("--resume"));
  }
  InstrumentOptions output;
  output.format = options.format;
  output.out = options.out;
  const int done = print_and_write_instrument(found.report, output);
  if (!found.result.complete) return interrupted_code();
  return saw_nothing(found.result) ? exit_requirement_failed : done;
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
                   "`verdict` or the error of a number beside it (separation, feature, normal, left, unit, point), "
                   "repeatable (default: all)")
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
