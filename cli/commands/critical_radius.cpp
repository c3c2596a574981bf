#include "cli/options/instrument_options.h"
#include "cli/progress_line.h"
#include "fuzz/queries/address.h"
#include "reports/instrument/critical_radius_report.h"

namespace axiscert {
namespace {

int measure(const InstrumentOptions& options) {
  const CriticalRadiusPlan plan{
      instrument_kernels(options,
                         {"published", "nonstrict", "reduced", "ladder-0", "minkowski", "closest-point", "segments",
                          "packed-nonstrict"},
                         Measures::verdicts),
      instrument_sources(options, {"general", "far", "sliver", "needle", "collinear", "repeated", "ratio", "scale"}),
      parse_precision(options.precision),
      options.trials,
      options.seed,
      options.threads};
  const auto result =
      with_progress("critical-radius", [&](const ShowProgress& show) { return measure_critical_radii(plan, show); });
  return put_instrument(critical_radius_report(plan, result, instrument_command("critical-radius", options)), options);
}

}  // namespace

void add_critical_radius(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("critical-radius",
                                     "Find the smallest radius for which each kernel says contact, and its error");
  auto options = std::make_shared<InstrumentOptions>();
  add_instrument_options(*command, *options, std::uint64_t{1} << 12);
  command->callback([&action, options] { action = [options] { return measure(*options); }; });
}

}  // namespace axiscert
