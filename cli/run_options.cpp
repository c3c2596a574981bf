#include "cli/run_options.h"

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/progress_line.h"
#include "cli/shared_options.h"
#include "cli/usage.h"
#include "fuzz/files/corpus.h"
#include "fuzz/text/number_text.h"
#include "plans/predicate_options.h"
#include "reports/gates/requirement.h"

namespace axiscert {

CLI::Option* add_source_options(CLI::App& command, SourceOptions& o) {
  add_predicate(
      command, o.predicate,
      "predicate whose kernels and families are the defaults, and of which all others have to be; see `axiscert "
      "predicates`",
      fmt::format("that of the kernels and families given, or {}", default_predicate().id));
  add_families(command, o.families, "all unless files are given");
  command.add_option("--mesh", o.meshes, "mesh file of any format assimp reads, repeatable")
      ->allow_extra_args(false)
      ->group(asked_group);
  add_query_files(command, o.queries);
  add_seed(command, o.seed);
  return add_trials(command, o.trials, default_trials_text());
}

void add_thread_option(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "worker threads (default: all cores)")
      ->check(whole_number(1, 4096))
      ->group(running_group);
}

void add_output_options(CLI::App& command, OutputOptions& o) {
  add_thread_option(command, o.threads);
  add_require_options(command, o.required);
  for (const char* name : {"--require", "--allow-unchecked"}) command.get_option(name)->group(required_group);
  command
      .add_option("--ratchet", o.ratchet,
                  "file of accepted errors, as a run writes it: exit 1 where anything is worse or a waiver has expired")
      ->group(required_group);
  command
      .add_option("--source", o.sources,
                  "[KERNEL=]FILE:LINE, where a kernel is written: the location of the results in report.sarif "
                  "(default: as a plug-in says of itself); repeatable")
      ->allow_extra_args(false)
      ->group(output_group);
  add_out(command, o.out, "record, reports and witnesses");
  add_format(command, o.format, {"csv"});
  add_quiet(command, o.quiet, "print only errors and failures");
  add_progress(command);
}

CLI::Option* add_plan_options(CLI::App& command, RunOptions& o) {
  add_kernels(command, o.kernels, "kernel id, or KERNEL@CALL for another way to call it, see `axiscert kernels`",
              "the first of the predicate");
  CLI::Option* trials = add_source_options(command, o);
  command.add_option("--corpus", o.corpus, "also run the corpus, from this folder or the one supplied with axiscert")
      ->expected(0, 1)
      ->default_str(default_corpus_folder())
      ->group(asked_group);
  add_precision(command, o.precision, of_csv_files, "both");
  command.add_option("--tolerance", o.tolerances, "[COMPARISON=]T: count errors above T u, repeatable")
      ->allow_extra_args(false)
      ->group(required_group);
  return trials;
}

void add_run_options(CLI::App& command, RunOptions& o) {
  CLI::Option* trials = add_plan_options(command, o);
  command
      .add_option("--time", o.seconds,
                  "seconds to run instead of a number of trials; units that were begun are finished")
      ->check(number_above_zero())
      ->excludes(trials)
      ->group(asked_group);
  add_target(command, o.target);
  command.add_option("--shrink", o.shrink, "also make the witnesses smaller, with at most this many evaluations each")
      ->expected(0, 1)
      ->default_str("1000")
      ->check(whole_number());
  command.add_flag("--exact-only", o.exact_only,
                   "judge every query by CGAL, arbitrary precision and MPFR, without filters: the record is the same");
  command.add_option("--plant", o.planted, "break the filter on purpose, to test that this is caught: exit 3")
      ->check(one_of(std::vector<std::string>(filter_fault_names.begin(), filter_fault_names.end())))
      ->excludes("--exact-only");
  command.add_option("--preset", o.preset, presets_text())->check(one_of(preset_names()));
  add_plugin_seconds(command);
  add_output_options(command, o);
}

void add_require_options(CLI::App& command, RunRequirements& required) {
  const std::vector<std::string_view> names = length_unit_names();
  command
      .add_option(
          "--require", required.levels,
          fmt::format("LEVEL or 'LEVEL in FAMILY,...' (patterns with * too), repeatable: exit 1 where it is not met "
                      "or not checked; {}",
                      levels_help()))
      ->allow_extra_args(false);
  command
      .add_option("--allow-unchecked", required.allow_unchecked,
                  "level of --require that passes where these queries or this kernel cannot show it, repeatable")
      ->allow_extra_args(false);
  command
      .add_option(
          "--unit", required.unit,
          "the unit of length of the queries' numbers, for lengths in levels and reports (families of scenes are "
          "in metres)")
      ->check(one_of({names.begin(), names.end()}));
}

}  // namespace axiscert
