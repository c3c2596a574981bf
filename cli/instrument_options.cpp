#include "cli/instrument_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/commands.h"
#include "cli/ending.h"
#include "cli/progress_line.h"
#include "cli/run_options.h"
#include "cli/shared_options.h"
#include "cli/usage.h"
#include "fuzz/files/corpus.h"
#include "fuzz/queries/sweep.h"
#include "plans/output_folder.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
void add_instrument_options(CLI::App& command, InstrumentOptions& o, std::uint64_t trials) {
  o.command = command.get_name();
  o.trials = trials;
  add_kernels(command, o.kernels, "kernel that is measured", "those that the documents show");
  add_families(command, o.families, "those that the documents show");
  add_trials(command, o.trials);
  add_seed(command, o.seed);
  add_precision(command, o.precision, "", o.precision.empty() ? "both" : "");
  add_thread_option(command, o.threads);
  add_plugin_seconds(command);
  add_progress(command);
  add_format(command, o.format, data_formats);
  add_out(command, o.out, "the figures as JSON, as CSV and as a page");
}

void add_own_queries(CLI::App& command, InstrumentOptions& o) {
  command.add_option("--mesh", o.meshes, "mesh file of any format assimp reads, repeatable")
      ->allow_extra_args(false)
      ->group(asked_group);
  add_query_files(command, o.queries);
  command.add_option("--corpus", o.corpus, "the corpus, from this folder or the one supplied with axiscert")
      ->expected(0, 1)
      ->default_str(default_corpus_folder())
      ->group(asked_group);
  command
      .add_option(
          "--sweep", o.sweep,
          "measure all queries again with each value of a parameter: offset=2^0..2^20 moves them so far in every "
          "coordinate, size=1,10,100 scales them about the sphere's centre, radius=0.5,1,2 multiplies the "
          "radius; numbers are rounded to --precision, and a query is judged as what it has become")
      ->check(known_by([](const std::string& text) { parse_sweep(text); }))
      ->group(asked_group);
}

void begin_instrument(const InstrumentOptions& options) {
  if (!options.out.empty()) make_folder(options.out);
  keep_nothing(fmt::format(
      "{} keeps nothing of a part of its figures; it asks less by fewer --trials (a tenth: --trials {}), kernels and "
      "families{}",
      options.command, std::max<std::uint64_t>(1, options.trials / 10),
      options.asks_less.empty() ? "" : ", and " + options.asks_less));
}

int print_and_write_instrument(const InstrumentReport& report, const InstrumentOptions& options) {
  fmt::print("{}", options.format == "text" ? instrument_text(report) : data_text(report.data, options.format));
  const int done = report.is_of_nothing ? exit_requirement_failed : exit_done;
  if (options.out.empty()) return done;
  make_folder(options.out);
  write_files(options.out, {{report.name + ".json", data_text(report.data, "json")},
                            {report.name + ".csv", data_text(report.data, "csv")},
                            {report.name + ".html", instrument_page(report)}});
  if (options.format == "text")
    fmt::print("{}\n", (std::filesystem::path(options.out) / (report.name + ".html")).string());
  return done;
}

}  // namespace axiscert
