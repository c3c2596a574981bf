#include <atomic>
#include <optional>

#include "cli/commands/run_output.h"
#include "cli/ending.h"
#include "cli/help.h"
#include "cli/instrument_options.h"
#include "cli/progress_line.h"
#include "cli/shared_options.h"
#include "cli/usage.h"
#include "plans/kernel_figures.h"
#include "reports/instrument/diagnosis_report.h"

namespace axiscert {
namespace {

int diagnose_kernel(const DiagnoseOptions& options) {
  const std::atomic<bool>& interrupted = watch_for_interrupts();
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);  // checked before anything runs
  const Diagnosed found =
      with_progress("diagnose", [&](const ShowProgress& show) { return diagnosed(options, interrupted, show); });
  if (folder) folder->write_text("witnesses.jsonl", diagnosis_witnesses(found.diagnosis));
  InstrumentOptions output;
  output.format = options.format;
  output.out = options.out;
  const int done = print_and_write_instrument(found.report, output);
  if (!found.diagnosis.complete) return interrupted_code();
  return found.diagnosis.looked_at().decided == 0 ? exit_requirement_failed : done;
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
