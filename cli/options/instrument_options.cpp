#include "cli/options/instrument_options.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/first_look.h"
#include "cli/options/run_options.h"
#include "cli/options/predicate_options.h"
#include "cli/progress_line.h"
#include "cli/usage.h"
#include "fuzz/queries/source.h"
#include "fuzz/queries/family.h"
#include "kernel/base/error.h"
#include "fuzz/confirm/record.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
void add_instrument_options(CLI::App& command, InstrumentOptions& o, std::uint64_t trials) {
  o.command = command.get_name();
  o.trials = trials;
  command.add_option("--kernel", o.kernels, "kernel id, repeatable")->allow_extra_args(false);
  command.add_option("--family", o.families, "family, repeatable")->allow_extra_args(false);
  command.add_option("--trials", o.trials, "queries per family")
      ->check(whole_number(1, std::uint64_t{1} << 48))
      ->capture_default_str();
  command.add_option("--seed", o.seed, "seed of every family")->check(whole_number())->capture_default_str();
  auto* precision = command.add_option("--precision", o.precision, "binary32 or binary64");
  if (o.precision.empty()) precision->default_str("both");
  else precision->capture_default_str();
  add_thread_option(command, o.threads);
  add_plugin_seconds(command);
  add_progress(command);
  add_format(command, o.format, data_formats);
  command.add_option("--out", o.out, "folder for the figures as JSON, as CSV and as a page");
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

std::vector<SourcePtr> instrument_sources(const InstrumentOptions& options, std::vector<std::string> defaults,
                                          const std::vector<const Predicate*>& served) {
  if (!options.out.empty()) make_folder(options.out);  // refused before anything runs
  std::vector<SourcePtr> sources;
  for (const std::string& name : options.families.empty() ? defaults : options.families) {
    const Family& family = find_family(name);
    require_served(options.command, family.predicate(), served);
    sources.push_back(family_source(family));
  }
  return sources;
}

std::string instrument_command(const std::string& name, const InstrumentOptions& options) {
  std::string command = "axiscert " + name;
  for (const std::string& kernel : options.kernels) command += " --kernel " + kernel;
  for (const std::string& family : options.families) command += " --family " + family;
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
