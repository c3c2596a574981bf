#include <fmt/format.h>

#include "cli/options/instrument_options.h"
#include "cli/progress_line.h"
#include "cli/values.h"
#include "fuzz/queries/address.h"
#include "kernel/base/error.h"
#include "reports/instrument/precision/condition_report.h"

namespace axiscert {
namespace {

struct ConditionOptions : InstrumentOptions {
  std::uint64_t flips = 256, sample = 64;
};

int measure(const ConditionOptions& options) {
  ConditionPlan plan{
      instrument_kernels(options, {"published", "reduced", "ladder-0"}, Measures::formulae),
      instrument_sources(options, {"general", "tangent", "seam", "sliver", "collinear", "far", "ratio", "scale"}),
      parse_precision(options.precision),
      options.trials,
      options.seed,
      options.flips,
      options.sample,
      options.threads};
  for (const Kernel* kernel : plan.kernels) {
    if (kernel->exposes == Exposure::verdict || !has_comparisons(*kernel)) {
      throw Error(
          fmt::format("--kernel {}: it shows a verdict alone, but conditions belong to comparisons; "
                      "'axiscert kernels' says which expose them",
                      kernel->id));
    }
  }
  const std::string command =
      instrument_command("condition", options) + fmt::format(" --flips {} --sample {}", options.flips, options.sample);
  const auto result =
      with_progress("condition", [&](const ShowProgress& show) { return measure_condition(plan, show); });
  return print_and_write_instrument(condition_report(plan, result, command), options);
}

}  // namespace

void add_condition(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "condition", "Distinguish flips caused by the query's condition from those caused by the formula");
  auto options = std::make_shared<ConditionOptions>();
  add_instrument_options(*command, *options, std::uint64_t{1} << 14);
  const CLI::Validator count = whole_number(0, std::uint64_t{1} << 32);
  command->add_option("--flips", options->flips, "flips evaluated per kernel, family and comparison")
      ->check(count)
      ->capture_default_str();
  command->add_option("--sample", options->sample, "queries per family that are evaluated where nothing flipped")
      ->check(count)
      ->capture_default_str();
  command->callback([&action, options] { action = [options] { return measure(*options); }; });
}

}  // namespace axiscert
