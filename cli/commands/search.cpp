#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "cli/options/instrument_options.h"
#include "cli/options/run_options.h"
#include "cli/options/test_options.h"
#include "cli/progress_line.h"
#include "cli/values.h"
#include "cli/running/run_output.h"
#include "fuzz/queries/address.h"
#include "fuzz/queries/entry_families.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/alike.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"
#include "fuzz/confirm/finding_record.h"
#include "reports/instrument/search_report.h"

namespace axiscert {
namespace {

struct SearchOptions {
  std::string test, kernel, precision = "binary32", target = "auto", format = "text", out;
  std::vector<std::string> comparisons, families;
  std::optional<std::uint64_t> evaluations;
  std::optional<double> seconds;
  std::uint64_t seed = 1;
  int threads = 0;
  bool resume = false;
};

// The number of evaluations where none is given: a few seconds.
constexpr std::uint64_t default_evaluations = std::uint64_t{1} << 24;
// Queries of each family in the run from which a search begins: together a second or two.
constexpr std::uint64_t first_queries = std::uint64_t{1} << 13;
// The same for a test other than sphere-triangle, whose oracles have no quick estimate.
constexpr std::uint64_t evaluations_by_oracles = std::uint64_t{1} << 14, first_by_oracles = std::uint64_t{1} << 9;
constexpr const char* state_file = "search.state";

Comparison parse_comparison(const std::string& given) {
  std::vector<std::string_view> known;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    if (comparisons[k].name == given) return static_cast<Comparison>(k);
    known.push_back(comparisons[k].name);
  }
  throw Error(fmt::format("--comparison {}: {}", given, unknown_name("comparison", "comparisons", given, known)));
}

const Kernel& kernel_of(const SearchOptions& options) {
  const Kernel& kernel =
      options.kernel.empty() ? default_kernel(test_given(options.test)) : find_kernel(options.kernel);
  test_of_kernels(options.test, {&kernel});
  require_moves("search", *kernel.test, kernel.entry);
  return kernel;
}

// The families that islands start from: those that were given; else of sphere-triangle some, of another test all.
std::vector<SourcePtr> sources_of(const SearchOptions& options, const Kernel& kernel) {
  std::vector<std::string> names = options.families;
  if (names.empty() && kernel.test == &first_test())
    names = {"general", "tangent", "seam", "sliver", "needle", "collinear", "repeated", "far", "ratio"};
  std::vector<SourcePtr> sources;
  for (const std::string& name : names) sources.push_back(family_source(find_family(name)));
  if (names.empty()) {
    for (const Family* family : families_of(*kernel.test, kernel.entry)) sources.push_back(family_source(*family));
  }
  require_one_test({&kernel}, sources);
  return sources;
}

SearchPlan plan_of(const SearchOptions& options) {
  SearchPlan plan;
  plan.kernel = &kernel_of(options);
  const bool is_first = plan.kernel->test == &first_test();
  require_loaded(*plan.kernel);
  plan.precision = parse_precision(options.precision);
  if (!plan.kernel->has(plan.precision)) {
    throw Error(fmt::format("--precision {}: kernel {} does not exist in it", options.precision, plan.kernel->id));
  }
  if (!options.comparisons.empty()) require_served("--comparison", *plan.kernel->test);
  for (const std::string& given : options.comparisons) {
    const Comparison which = parse_comparison(given);
    const auto& so_far = plan.comparisons;
    if (std::find(so_far.begin(), so_far.end(), which) == so_far.end()) plan.comparisons.push_back(which);
  }
  if (!plan.comparisons.empty() && aims_of(*plan.kernel, plan.comparisons).empty()) {
    throw Error(
        fmt::format("--comparison: kernel {} does not show the computed sides of its own formulae", plan.kernel->id));
  }
  std::sort(plan.comparisons.begin(), plan.comparisons.end());
  plan.sources = sources_of(options, *plan.kernel);
  // The run from which it begins has every family, as `axiscert run` does, unless some are given.
  plan.first_queries = is_first ? first_queries : first_by_oracles;
  if (!options.families.empty()) plan.first_sources = plan.sources;
  else
    for (const Family* family : families_of(*plan.kernel->test, plan.kernel->entry))
      plan.first_sources.push_back(family_source(*family));
  plan.seed = options.seed;
  plan.seconds = options.seconds;
  plan.evaluations = options.evaluations;
  if (!plan.seconds && !plan.evaluations) plan.evaluations = is_first ? default_evaluations : evaluations_by_oracles;
  plan.target = resolve_target(options.target);
  plan.threads = threads_of(options.threads);
  return plan;
}

std::string command_of(const SearchOptions& options, const SearchPlan& plan, const SearchResult& result) {
  std::string command = fmt::format("axiscert search --kernel {} --precision {}", plan.kernel->id, options.precision);
  for (const std::string& which : options.comparisons) command += " --comparison " + which;
  for (const std::string& family : options.families) command += " --family " + family;
  return command + fmt::format(" --evaluations {} --seed {}", result.evaluations, options.seed);
}

int search(const SearchOptions& options) {
  const SearchPlan plan = plan_of(options);
  std::optional<std::string> state;
  if (options.resume) {
    if (options.out.empty()) throw Error("--resume: give the folder of the search to resume with --out");
    const std::filesystem::path stored = std::filesystem::path(options.out) / state_file;
    std::error_code ignored;
    if (!std::filesystem::exists(stored, ignored)) {
      throw Error(
          fmt::format("--resume --out {}: there is no {}; give the folder of a search that was begun with --out",
                      options.out, stored.string()));
    }
    state = read_bytes((std::filesystem::path(options.out) / state_file).string());
  }
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);  // checked before anything runs
  require_uncontracted(plan.target);

  const std::atomic<bool>& interrupted = watch_for_interrupts();
  SearchResult result;
  {
    ProgressLine progress("search");
    const std::string asked_for = plan.evaluations ? fmt::format(" of {}", *plan.evaluations) : "";
    result = search(plan, state, interrupted, [&](const SearchProgress& p) {
      progress.show({p.islands, 0, 0, p.seconds}, fmt::format("; {}{} evaluations", p.evaluations, asked_for));
    });
  }
  if (folder) {
    folder->write_text(state_file, result.state);
    folder->write_text("witnesses.jsonl", search_witnesses(result));
  }
  InstrumentOptions output;
  output.format = options.format;
  output.out = options.out;
  const int done = put_instrument(search_report(plan, result, command_of(options, plan, result)), output);
  return result.complete ? done : exit_interrupted;
}

}  // namespace

void add_search(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("search",
                                     "Search for the worst cases of a kernel: errors of its comparisons, wrong "
                                     "verdicts, the scales where range fails");
  auto options = std::make_shared<SearchOptions>();
  SearchOptions& o = *options;
  add_test_option(*command, o.test, "the test of which the kernel is (default: sphere-triangle, or that of --kernel)");
  command->add_option("--kernel", o.kernel, "kernel id (default: the first of the test)");
  command->add_option("--precision", o.precision, "binary32 or binary64")->capture_default_str();
  command->add_option("--comparison", o.comparisons, "comparison, repeatable (default: all, and the verdict)")
      ->allow_extra_args(false);
  command->add_option("--family", o.families, "family from which the search starts, repeatable")
      ->allow_extra_args(false);
  auto* evaluations =
      command
          ->add_option("--evaluations", o.evaluations,
                       "queries to evaluate, rounded up to whole islands (default: 2^24, of a test other "
                       "than sphere-triangle 2^14); the short run from which it begins is not counted")
          ->check(whole_number(1, std::uint64_t{1} << 48));
  command->add_option("--time", o.seconds, "seconds to search instead")
      ->check(number_above_zero())
      ->excludes(evaluations);
  command->add_option("--seed", o.seed, "seed of all random choices")->check(whole_number())->capture_default_str();
  command->add_flag("--resume", o.resume, "continue from the state in the folder of --out");
  command->add_option("--target", o.target, "instruction set, or auto")->capture_default_str();
  add_thread_option(*command, o.threads);
  add_plugin_seconds(*command);
  add_progress(*command);
  add_format(*command, o.format, data_formats);
  command->add_option("--out", o.out, "folder for search.json, search.csv, search.html, witnesses.jsonl and the state");
  command->callback([&action, options] { action = [options] { return search(*options); }; });
}

}  // namespace axiscert
