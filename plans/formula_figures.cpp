#include "plans/formula_figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "exact/numbers/number_format.h"
#include "exact/sphere_triangle/unbounded.h"
#include "kernel/base/error.h"
#include "kernel/formulae_list.h"
#include "kernel/registry/self_check.h"
#include "reports/instrument/condition_report.h"
#include "reports/instrument/ladder_report.h"
#include "reports/instrument/precision_report.h"

namespace axiscert {
namespace {

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
// The cells of the factorial in their order.
std::vector<std::string> factorial_kernels() {
  std::vector<std::string> ids;
  for (const FactorialCell& cell : factorial_cells()) ids.emplace_back(name(cell.formulae));
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

}  // namespace

InstrumentReport ladder_figures(const LadderOptions& options, const ShowProgress& show) {
  if (options.factorial && !options.kernels.empty()) {
    throw Error(fmt::format("--factorial measures kernels of its own, and {} is given; leave out one of the two",
                            options.kernels.front()));
  }
  LadderPlan plan;
  plan.precision = parse_precision(options.precision);
  plan.kernels =
      instrument_kernels(options, options.factorial ? factorial_kernels() : default_kernels(), Measures::comparisons);
  for (const Kernel* kernel : plan.kernels) require_comparisons(*kernel);
  plan.sources = instrument_sources(options, ladder_families);
  plan.trials = options.trials;
  plan.seed = options.seed;
  plan.speed = !options.no_speed;
  plan.threads = options.threads;
  require_uncontracted(scalar_target);
  const std::string command = instrument_command("ladder", options) + (options.factorial ? " --factorial" : "") +
                              (options.no_speed ? " --no-speed" : "");
  return ladder_report(plan, measure_ladder(plan, show), command);
}

namespace {

std::vector<NumberFormat> numbers_of(const PrecisionOptions& options) {
  std::vector<NumberFormat> numbers;
  for (const int b : options.bits) {
    if (b < least_bits || b > greatest_bits) {
      throw Error(fmt::format("--bits {}: a precision is {} to {} bits", b, least_bits, greatest_bits));
    }
    numbers.push_back(format_of_bits(b));
  }
  for (const std::string& text : options.numbers) numbers.push_back(parse_number_format(text));
  if (numbers.empty()) numbers = default_precision_numbers();
  std::ranges::stable_sort(numbers, {}, &NumberFormat::bits);
  std::vector<NumberFormat> once;
  for (const NumberFormat& number : numbers) {
    if (std::ranges::find(once, number) == once.end()) once.push_back(number);
  }
  return once;
}

}  // namespace

InstrumentReport precision_figures(const PrecisionOptions& options, const ShowProgress& show) {
  PrecisionPlan plan;
  plan.seed = options.seed;
  plan.trials = options.trials;
  plan.precision = parse_precision(options.precision);
  plan.numbers = numbers_of(options);
  plan.threads = options.threads;
  plan.rounding = enumerator_of<RoundingRule>("--rounding ", options.rounding);
  if (options.rounding_seeds && !is_by_chance(plan.rounding))
    throw Error(fmt::format("--rounding-seeds {}: --rounding {} draws no numbers; seeds are of faithful and stochastic",
                            *options.rounding_seeds, options.rounding));
  plan.rounding_seeds = options.rounding_seeds.value_or(default_rounding_seeds);
  plan.contraction = enumerator_of<Contraction>("--contraction ", options.contraction);
  plan.round_inputs = options.round_inputs;
  plan.kernels = instrument_kernels(options,
                                    {"ladder-0", "ladder-1", "ladder-2", "ladder-3", "ladder-4", "ladder-5", "ladder-6",
                                     "ladder-7", "ladder-8", "ladder-9", "reduced", "reduced-nonstrict", "nonstrict"},
                                    Measures::formulae);
  plan.sources = instrument_sources(options, {"general", "tangent", "seam", "sliver", "scale", "collinear", "lattice"});
  std::string command = instrument_command("precision", options);
  for (const int b : options.bits) command += fmt::format(" --bits {}", b);
  for (const std::string& number : options.numbers) command += " --number " + number;
  const PrecisionOptions defaults;
  if (options.rounding != defaults.rounding) command += " --rounding " + options.rounding;
  if (is_by_chance(plan.rounding)) command += fmt::format(" --rounding-seeds {}", plan.rounding_seeds);
  if (options.contraction != defaults.contraction) command += " --contraction " + options.contraction;
  if (options.round_inputs) command += " --round-inputs";
  return precision_report(plan, measure_precision(plan, show), command);
}

InstrumentReport condition_figures(const ConditionOptions& options, const ShowProgress& show) {
  ConditionPlan plan{
      instrument_kernels(options, {"published", "reduced", "ladder-0"}, Measures::comparisons),
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
  return condition_report(plan, measure_condition(plan, show), command);
}

}  // namespace axiscert
