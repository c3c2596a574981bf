#include "cli/options/instrument_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/ending.h"
#include "cli/first_look.h"
#include "cli/options/run_options.h"
#include "cli/options/predicate_options.h"
#include "cli/options/shared_options.h"
#include "cli/progress_line.h"
#include "cli/usage.h"
#include "fuzz/files/file_parts.h"
#include "fuzz/queries/source.h"
#include "reports/wording/reproduce.h"
#include "fuzz/queries/family.h"
#include "kernel/base/error.h"
#include "fuzz/confirm/record.h"
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

std::vector<const Kernel*> instrument_kernels(const InstrumentOptions& options, std::vector<std::string> defaults,
                                              Measures measures, const std::vector<const Predicate*>& served) {
  const Precision precision = parse_precision(options.precision);
  std::vector<const Kernel*> kernels;
  for (const std::string& id : options.kernels.empty() ? defaults : options.kernels) {
    const Kernel& kernel = find_kernel(id);
    require_served(options.command, *kernel.predicate, served);
    if (measures == Measures::formulae && !kernel.file.empty()) {
      throw Error(
          fmt::format("--kernel {}: this command measures built-in formulae; plug-ins are accepted by run, check, "
                      "critical-radius and league",
                      id));
    }
    if (measures == Measures::formulae && kernel.call != Call{}) {
      throw Error(fmt::format(
          "--kernel {}: this command measures formulae in an arithmetic, which '@CALL' does not change", id));
    }
    require_loaded(kernel);
    if (!kernel.has(precision)) {
      throw Error(fmt::format("--precision {}: kernel {} does not exist in it", options.precision, id));
    }
    kernels.push_back(&kernel);
  }
  print_first_look(kernels);
  return kernels;
}

namespace {

// For an interrupt: the figures are of all queries or of none.
void say_how_to_ask_less(const InstrumentOptions& options) {
  keep_nothing(fmt::format(
      "{} keeps nothing of a part of its figures; it asks less by fewer --trials (a tenth: --trials {}), kernels and "
      "families{}",
      options.command, std::max<std::uint64_t>(1, options.trials / 10),
      options.asks_less.empty() ? "" : ", and " + options.asks_less));
}

}  // namespace

EntryAsked entry_asked(const InstrumentOptions& options) {
  std::vector<const Kernel*> kernels;
  for (const std::string& id : options.kernels) kernels.push_back(&find_kernel(id));
  if (!kernels.empty()) return {&predicate_of_kernels("", kernels), kernels.front()->entry};
  for (const std::string& name : options.families) {
    if (name == "all") continue;
    const Family& family = find_family(name);
    return {&family.predicate(), family.entry};
  }
  return {&default_predicate(), 0};
}

std::vector<SourcePtr> instrument_sources(const InstrumentOptions& options, std::vector<std::string> defaults,
                                          const std::vector<const Predicate*>& served) {
  if (!options.out.empty()) make_folder(options.out);  // refused before anything runs
  say_how_to_ask_less(options);
  const auto [predicate, entry] = entry_asked(options);
  std::vector<SourcePtr> sources;
  const Precision csv_precision = parse_precision(options.precision.empty() ? "binary32" : options.precision);
  for (const std::string& file : options.queries) {
    for (const SourcePtr& part : query_file_sources(file, csv_precision)) {
      if (&part->predicate() == predicate && part->entry() == entry) sources.push_back(part);
    }
  }
  if (!sources.empty() && options.families.empty()) return sources;
  for (const Family* family :
       families_named(options.families.empty() ? defaults : options.families, *predicate, entry)) {
    require_served(options.command, family->predicate(), served);
    sources.push_back(family_source(*family));
  }
  return sources;
}

std::string instrument_command(const std::string& name, const InstrumentOptions& options) {
  std::string command = "axiscert " + name;
  for (const std::string& kernel : options.kernels) command += " --kernel " + kernel;
  for (const std::string& family : options.families) command += " --family " + family;
  for (const std::string& file : options.queries) command += " --queries " + shell_word(file);
  command += fmt::format(" --trials {} --seed {}", options.trials, options.seed);
  return options.precision.empty() ? command : command + " --precision " + options.precision;
}

int print_and_write_instrument(const InstrumentReport& report, const InstrumentOptions& options) {
  fmt::print("{}", options.format == "text" ? instrument_text(report) : data_text(report.data, options.format));
  if (options.out.empty()) return exit_done;
  make_folder(options.out);
  write_files(options.out, {{report.name + ".json", data_text(report.data, "json")},
                            {report.name + ".csv", data_text(report.data, "csv")},
                            {report.name + ".html", instrument_page(report)}});
  if (options.format == "text")
    fmt::print("{}\n", (std::filesystem::path(options.out) / (report.name + ".html")).string());
  return exit_done;
}

}  // namespace axiscert
