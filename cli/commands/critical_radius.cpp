#include "cli/options/instrument_options.h"
#include "cli/options/predicate_options.h"
#include "cli/progress_line.h"
#include "fuzz/queries/address.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/entry_families.h"
#include "fuzz/queries/image_groups.h"
#include "reports/instrument/precision/critical_radius_report.h"

namespace axiscert {
namespace {

// Those that the predicate names; else all kernels and families of the entry but images, which are the same radius
// again.
CriticalRadiusDefaults defaults_of(const Predicate& predicate, std::size_t entry) {
  if (const CriticalRadiusDefaults* chosen = capabilities_of(predicate).critical_radius_defaults) return *chosen;
  CriticalRadiusDefaults all;
  for (const Kernel& kernel : kernels()) {
    if (kernel.predicate == &predicate && kernel.entry == entry) all.kernels.push_back(kernel.id);
  }
  for (const Family* family : families_of(predicate, entry)) {
    if (image_group(family->name) == nullptr) all.families.emplace_back(family->name);
  }
  return all;
}

// The predicate and the entry of the kernels or the families that are given; the first where neither are.
std::pair<const Predicate*, std::size_t> asked_of(const InstrumentOptions& options) {
  std::vector<const Kernel*> kernels;
  for (const std::string& id : options.kernels) kernels.push_back(&find_kernel(id));
  if (kernels.empty() && !options.families.empty()) {
    const Family& first = find_family(options.families.front());
    return {&first.predicate(), first.entry};
  }
  return {&predicate_of_kernels("", kernels), kernels.empty() ? 0 : kernels.front()->entry};
}

int measure(const InstrumentOptions& options) {
  const std::vector<const Predicate*> served = predicates_with(has_critical_length);
  const auto [predicate, entry] = asked_of(options);
  require_capability(has_critical_length, options.command, *predicate, entry);
  const CriticalRadiusDefaults defaults = defaults_of(*predicate, entry);
  const CriticalRadiusPlan plan{instrument_kernels(options, defaults.kernels, Measures::verdicts, served),
                                instrument_sources(options, defaults.families, served),
                                parse_precision(options.precision),
                                options.trials,
                                options.seed,
                                options.threads};
  require_one_predicate(plan.kernels, plan.sources);
  const auto result =
      with_progress("critical-radius", [&](const ShowProgress& show) { return measure_critical_radii(plan, show); });
  const int done = print_and_write_instrument(
      critical_radius_report(plan, result, instrument_command("critical-radius", options)), options);
  return unmeasured_kernels(plan, result).empty() ? done : exit_requirement_failed;
}

}  // namespace

void add_critical_radius(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "critical-radius",
      "Find the smallest radius, or half extent of a box, for which each kernel says contact, and its "
      "error");
  auto options = std::make_shared<InstrumentOptions>();
  add_instrument_options(*command, *options, std::uint64_t{1} << 12);
  command->callback([&action, options] { action = [options] { return measure(*options); }; });
}

}  // namespace axiscert
