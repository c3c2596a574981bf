#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/options/instrument_options.h"
#include "cli/progress_line.h"
#include "fuzz/queries/address.h"
#include "kernel/base/error.h"
#include "kernel/formulae_list.h"
#include "kernel/registry/self_check.h"
#include "reports/instrument/precision/ladder_report.h"

namespace axiscert {
namespace {

struct LadderOptions : InstrumentOptions {
  bool no_speed = false;
};

// Every rung with `>`, in the order of formulae_list.h, but published, which is ladder-9 bit for bit.
std::vector<std::string> default_kernels() {
  std::vector<const Kernel*> rungs;
  for (const Kernel& kernel : kernels()) {
    const Formulae formulae = formulae_of(kernel);
    const bool has_own_steps = kernel.takes_arithmetic && formulae != Formulae::none && formulae != Formulae::published;
    if (has_own_steps && kernel.strictness == Strictness::strict) rungs.push_back(&kernel);
  }
  std::stable_sort(rungs.begin(), rungs.end(),
                   [](const Kernel* a, const Kernel* b) { return formulae_of(*a) < formulae_of(*b); });
  std::vector<std::string> ids;
  for (const Kernel* rung : rungs) ids.push_back(rung->id);
  return ids;
}
const std::vector<std::string> ladder_families = {"general", "tangent", "seam", "sliver", "far", "scale"};

void require_comparisons(const Kernel& kernel) {
  if (kernel.exposes != Exposure::verdict) return;
  std::vector<std::string_view> able;
  for (const Kernel& other : kernels()) {
    if (other.predicate == kernel.predicate && other.exposes != Exposure::verdict) able.push_back(other.id);
  }
  throw Error(
      fmt::format("--kernel {}: it shows only its verdict, but ladder measures comparisons; kernels that show "
                  "them: {}, and RUNG+ARITHMETIC",
                  kernel.id, fmt::join(able, ", ")));
}

int ladder(const LadderOptions& options) {
  LadderPlan plan;
  plan.precision = parse_precision(options.precision);
  plan.kernels = instrument_kernels(options, default_kernels(), Measures::formulae);
  for (const Kernel* kernel : plan.kernels) require_comparisons(*kernel);
  plan.sources = instrument_sources(options, ladder_families);
  plan.trials = options.trials;
  plan.seed = options.seed;
  plan.speed = !options.no_speed;
  plan.threads = options.threads;
  require_uncontracted(scalar_target);
  const std::string command = instrument_command("ladder", options) + (options.no_speed ? " --no-speed" : "");
  const auto entries = with_progress("ladder", [&](const ShowProgress& show) { return measure_ladder(plan, show); });
  return print_and_write_instrument(ladder_report(plan, entries, command), options);
}

}  // namespace

void add_ladder(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("ladder", "Measure what each step of the derivation costs: errors, range, time");
  auto options = std::make_shared<LadderOptions>();
  add_instrument_options(*command, *options, std::uint64_t{1} << 14);
  command->add_flag("--no-speed", options->no_speed,
                    "measure no times: the rest of the output is the same in every run");
  command->callback([&action, options] { action = [options] { return ladder(*options); }; });
}

}  // namespace axiscert
