// axiscert precision: the formulae at every number of bits, with and without a limit on exponents.
#include <fmt/format.h>

#include <algorithm>

#include "cli/options/instrument_options.h"
#include "cli/progress_line.h"
#include "exact/sphere_triangle/unbounded/at_precision.h"
#include "fuzz/queries/address.h"
#include "kernel/base/error.h"
#include "reports/instrument/precision/precision_report.h"

namespace axiscert {
namespace {

struct PrecisionOptions : InstrumentOptions {
  std::vector<int> bits;
};

std::vector<int> bits_of(const PrecisionOptions& options) {
  std::vector<int> bits = options.bits.empty() ? default_precision_bits() : options.bits;
  for (const int b : bits) {
    if (b < least_bits || b > greatest_bits) {
      throw Error(fmt::format("--bits {}: a precision is {} to {} bits", b, least_bits, greatest_bits));
    }
  }
  std::sort(bits.begin(), bits.end());
  bits.erase(std::unique(bits.begin(), bits.end()), bits.end());
  return bits;
}

int measure(const PrecisionOptions& options) {
  PrecisionPlan plan;
  plan.seed = options.seed;
  plan.trials = options.trials;
  plan.precision = parse_precision(options.precision);
  plan.bits = bits_of(options);
  plan.threads = options.threads;
  plan.kernels = instrument_kernels(options,
                                    {"ladder-0", "ladder-1", "ladder-2", "ladder-3", "ladder-4", "ladder-5", "ladder-6",
                                     "ladder-7", "ladder-8", "ladder-9", "reduced", "reduced-nonstrict", "nonstrict"},
                                    Measures::formulae);
  plan.sources = instrument_sources(options, {"general", "tangent", "seam", "sliver", "scale", "collinear", "lattice"});
  std::string command = instrument_command("precision", options);
  for (const int b : options.bits) command += fmt::format(" --bits {}", b);
  const auto tallies =
      with_progress("precision", [&](const ShowProgress& show) { return measure_precision(plan, show); });
  return print_and_write_instrument(precision_report(plan, tallies, command), options);
}

}  // namespace

void add_precision(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "precision", "Evaluate formulae at 8 to 256 bits: what rounding costs, apart from what range costs");
  auto options = std::make_shared<PrecisionOptions>();
  add_instrument_options(*command, *options, std::uint64_t{1} << 11);
  command->add_option("--bits", options->bits, "bits of precision, repeatable (default: 26 values from 8 to 256)")
      ->allow_extra_args(false);
  command->callback([&action, options] { action = [options] { return measure(*options); }; });
}

}  // namespace axiscert
