// axiscert precision: the formulae at every number of bits, with and without a limit on exponents.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/help.h"
#include "cli/instrument_options.h"
#include "cli/progress_line.h"
#include "cli/run_options.h"
#include "cli/shared_options.h"
#include "cli/usage.h"
#include "exact/numbers/number_format.h"
#include "exact/sphere_triangle/unbounded.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"
#include "plans/formula_figures.h"
#include "plans/given_queries.h"
#include "plans/predicate_options.h"
#include "reports/instrument/critical_radius_report.h"

namespace axiscert {
namespace {

int ladder(const LadderOptions& options) {
  begin_instrument(options);
  const auto figures = [&](const ShowProgress& show) { return ladder_figures(options, show); };
  return print_and_write_instrument(with_progress("ladder", figures), options);
}

}  // namespace

void add_ladder(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("ladder", "Measure what each step of the derivation costs: errors, range, time");
  auto options = std::make_shared<LadderOptions>();
  add_instrument_options(*command, *options, ladder_trials);
  add_own_queries(*command, *options);
  command->add_flag("--no-speed", options->no_speed,
                    "measure no times: the rest of the output is the same in every run");
  options->asks_less = "--no-speed measures no times";
  command->add_flag(
      "--factorial", options->factorial,
      "measure in place of the rungs every combination of the edges' four choices, and of the plane's two");
  add_examples(
      *command,
      {{"The effect of each choice, all others alike", "axiscert ladder --factorial --trials 256 --no-speed"},
       {"Four steps, without times", "axiscert ladder ladder-0 ladder-3 ladder-6 published --trials 256 --no-speed"},
       {"All of the figures, with a page", "axiscert ladder --out ladder"}});
  command->callback([&action, options] { action = [options] { return ladder(*options); }; });
}

namespace {

template <class Enum>
std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const Enum each : enumerators<Enum>) names.emplace_back(name(each));
  return names;
}

int measure(const PrecisionOptions& options) {
  begin_instrument(options);
  const auto figures = [&](const ShowProgress& show) { return precision_figures(options, show); };
  return print_and_write_instrument(with_progress("precision", figures), options);
}

}  // namespace

void add_precision(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("precision",
                                     "Evaluate formulae in bfloat16, binary16, fp8 and other formats, or at 2 to 4096 "
                                     "bits: what rounding costs, apart from what range costs");
  auto options = std::make_shared<PrecisionOptions>();
  add_instrument_options(*command, *options, precision_trials);
  add_own_queries(*command, *options);
  command
      ->add_option("--number", options->numbers,
                   "format of the operations, repeatable: " + number_formats_text() +
                       ", whose exponents are from 1-E to E; beside each, the same bits with unlimited exponents")
      ->check(known_by([](const std::string& text) { parse_number_format(text); }))
      ->allow_extra_args(false);
  options->asks_less = "each --number or --bits is one format in place of 26";
  command
      ->add_option("--bits", options->bits,
                   "bits of precision with the exponents of the queries, repeatable; with neither this nor --number 26 "
                   "values from 8 to 256")
      ->allow_extra_args(false);
  command
      ->add_option("--rounding", options->rounding,
                   "rounding of each operation: nearest, up, down, zero; faithful: to either neighbour by a coin; "
                   "stochastic: with a probability proportional to the distance of the other neighbour")
      ->check(one_of(all_names<RoundingRule>()))
      ->capture_default_str();
  command
      ->add_option("--rounding-seeds", options->rounding_seeds,
                   fmt::format("of faithful and stochastic rounding, measure with the seeds 1 to so many (default: {})",
                               default_rounding_seeds))
      ->check(whole_number(1, 1000));
  command
      ->add_option("--contraction", options->contraction,
                   "operations that are fused: none, or dots, the dot and cross products")
      ->check(one_of(all_names<Contraction>()))
      ->capture_default_str();
  command->add_flag("--round-inputs", options->round_inputs,
                    "round each query to the format first, and judge it as what it has become; otherwise queries are "
                    "taken as they are, and what the operations alone cost is shown");
  add_examples(*command,
               {{"Formats by name, on queries that these have",
                 "axiscert precision published --number bfloat16 --number binary16 --number fp8-e4m3 --round-inputs "
                 "--trials 64"},
                {"A format of my own, rounded by chance",
                 "axiscert precision published --number bits=10,emax=31 --rounding stochastic --trials 64"},
                {"Far from the origin, with a page",
                 "axiscert precision published --bits 16 --bits 24 --sweep offset=2^0..2^4 --precision binary64 "
                 "--trials 64 --out far"}});
  command->callback([&action, options] { action = [options] { return measure(*options); }; });
}

namespace {

int measure(const ConditionOptions& options) {
  begin_instrument(options);
  const auto figures = [&](const ShowProgress& show) { return condition_figures(options, show); };
  return print_and_write_instrument(with_progress("condition", figures), options);
}

}  // namespace

void add_condition(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "condition", "Distinguish flips caused by the query's condition from those caused by the formula");
  auto options = std::make_shared<ConditionOptions>();
  add_instrument_options(*command, *options, condition_trials);
  add_own_queries(*command, *options);
  const CLI::Validator count = whole_number(0, std::uint64_t{1} << 32);
  command->add_option("--flips", options->flips, "flips evaluated per kernel, family and comparison")
      ->check(count)
      ->capture_default_str();
  command->add_option("--sample", options->sample, "queries per family that are evaluated where nothing flipped")
      ->check(count)
      ->capture_default_str();
  add_examples(*command, {{"One kernel on one family", "axiscert condition published --family tangent --trials 256"},
                          {"All of the figures, with a page", "axiscert condition --out condition"}});
  command->callback([&action, options] { action = [options] { return measure(*options); }; });
}

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

int measure_part(const InstrumentOptions& options) {
  const std::vector<const Predicate*> served = predicates_with(has_critical_length);
  const auto [predicate, entry] = entry_asked(options);
  require_capability(has_critical_length, options.command, *predicate, entry);
  const CriticalRadiusDefaults defaults = defaults_of(*predicate, entry);
  begin_instrument(options);
  const CriticalRadiusPlan plan{instrument_kernels(options, defaults.kernels, Measures::verdicts, served),
                                instrument_sources(options, defaults.families, served),
                                parse_precision(options.precision),
                                options.trials,
                                options.seed,
                                options.threads};
  require_one_predicate(plan.kernels, plan.sources);
  print_left_out(plan.sources, {plan.precision});
  const auto result =
      with_progress("critical-radius", [&](const ShowProgress& show) { return measure_critical_radii(plan, show); });
  const int done = print_and_write_instrument(
      critical_radius_report(plan, result, instrument_command("critical-radius", options)), options);
  return unmeasured_kernels(plan, result).empty() ? done : exit_requirement_failed;
}

// Each predicate and entry of the query files by itself, in a folder of its own where there are several.
int measure_radii(const InstrumentOptions& options) {
  const std::vector<QueryPart> parts =
      query_parts(options.queries, parse_precision(options.precision), "", options.kernels);
  if (parts.empty()) return measure_part(options);
  if (parts.size() > 1 && !options.families.empty())
    throw Error(fmt::format("--family is of one predicate, and the queries are of {}", parts.size()));
  if (parts.size() > 1 && options.format != "text" && options.out.empty()) {
    throw Error(
        fmt::format("--format {}: the queries are of {} predicates or entries, and a document is of one; "
                    "--out DIR has a folder of each",
                    options.format, parts.size()));
  }
  int code = exit_done;
  for (const QueryPart& part : parts) {
    InstrumentOptions own = options;
    if (parts.size() > 1) own.kernels = part.kernels;
    if (own.kernels.empty()) own.kernels = defaults_of(*part.predicate, part.entry).kernels;
    if (parts.size() > 1 && !own.out.empty()) own.out = (std::filesystem::path(own.out) / part.folder()).string();
    code = std::max(code, measure_part(own));
  }
  return code;
}

}  // namespace

void add_critical_radius(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "critical-radius",
      "Find the smallest radius, or half extent of a box, for which each kernel says contact, and its "
      "error");
  auto options = std::make_shared<InstrumentOptions>();
  add_instrument_options(*command, *options, std::uint64_t{1} << 12);
  add_own_queries(*command, *options);
  add_examples(*command,
               {{"Two kernels", "axiscert critical-radius published certified --trials 64"},
                {"One family, with a page", "axiscert critical-radius certified --family far --trials 64 --out radii"},
                {"My own queries", "axiscert critical-radius published --queries mine.jsonl"}});
  command->callback([&action, options] { action = [options] { return measure_radii(*options); }; });
}

}  // namespace axiscert
