#include <fmt/format.h>

#include <atomic>

#include "cli/ending.h"
#include "cli/first_look.h"
#include "cli/options/instrument_options.h"
#include "cli/options/shared_options.h"
#include "cli/help.h"
#include "cli/progress_line.h"
#include "cli/running/run_output.h"
#include "cli/usage.h"
#include "fuzz/confirm/record.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"
#include "reports/instrument/diagnosis_report.h"

namespace axiscert {
namespace {

struct DiagnoseOptions {
  std::string kernel, precision, format = "text", out;
  std::uint64_t seed = 1;
};

// The precision that is given, or the first in which the kernel exists.
Precision precision_for(const DiagnoseOptions& options, const Kernel& kernel) {
  if (options.precision.empty()) return kernel.has(Precision::binary32) ? Precision::binary32 : Precision::binary64;
  const Precision precision = parse_precision(options.precision);
  if (!kernel.has(precision)) {
    throw Error(fmt::format("--precision {}: kernel {} does not exist in it", options.precision, kernel.id));
  }
  return precision;
}

int diagnose_kernel(const DiagnoseOptions& options) {
  const Kernel& kernel = find_kernel(options.kernel);
  require_loaded(kernel);
  print_first_look(kernel);
  DiagnosisOptions asked;
  asked.precision = precision_for(options, kernel);
  asked.seed = options.seed;
  asked.interrupted = &watch_for_interrupts();
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);  // checked before anything runs
  const Diagnosis diagnosis = with_progress("diagnose", [&](const ShowProgress& show) {
    asked.report = show;
    return diagnose(kernel, asked);
  });
  if (folder) folder->write_text("witnesses.jsonl", diagnosis_witnesses(diagnosis));
  InstrumentOptions output;
  output.format = options.format;
  output.out = options.out;
  const std::string command =
      fmt::format("axiscert diagnose {} --precision {} --seed {}", kernel.id, name(asked.precision), options.seed);
  const int done = print_and_write_instrument(diagnosis_report(diagnosis, command), output);
  if (!diagnosis.complete) return interrupted_code();
  return diagnosis.looked_at().decided == 0 ? exit_requirement_failed : done;
}

}  // namespace

void add_diagnose(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "diagnose", "Say what a kernel is like by its verdicts: open or closed, one-sided, thresholds, order, precision");
  auto options = std::make_shared<DiagnoseOptions>();
  DiagnoseOptions& o = *options;
  add_kernel(*command, o.kernel, "kernel that is asked");
  add_precision(*command, o.precision, "", "the first that the kernel has");
  add_seed(*command, o.seed);
  add_plugin_seconds(*command);
  add_progress(*command);
  add_format(*command, o.format, data_formats);
  add_out(*command, o.out, "diagnosis.json, diagnosis.csv, diagnosis.html and witnesses.jsonl");
  add_examples(*command, {{"What is my kernel like?", "axiscert diagnose plugin:./my_kernel.so"},
                          {"With a page and the queries that show it",
                           "axiscert diagnose published --precision binary64 --out diagnosis"}});
  command->callback([&action, options] {
    if (options->kernel.empty()) throw CLI::RequiredError("KERNEL");
    action = [options] { return diagnose_kernel(*options); };
  });
}

}  // namespace axiscert
