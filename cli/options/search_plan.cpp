#include "cli/options/search_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/options/run_options.h"
#include "cli/options/test_options.h"
#include "fuzz/confirm/finding_record.h"
#include "fuzz/queries/address.h"
#include "fuzz/queries/entry_families.h"
#include "kernel/base/alike.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"

namespace axiscert {
namespace {

// The number of evaluations where none is given: a few seconds.
constexpr std::uint64_t default_evaluations = std::uint64_t{1} << 24;
// Queries of each family in the run from which a search begins: together a second or two.
constexpr std::uint64_t first_queries = std::uint64_t{1} << 13;
// The same for a test other than sphere-triangle, whose oracles have no quick estimate.
constexpr std::uint64_t evaluations_by_oracles = std::uint64_t{1} << 14, first_by_oracles = std::uint64_t{1} << 9;

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
std::vector<SourcePtr> beginning_sources(const SearchOptions& options, const Kernel& kernel) {
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

}  // namespace

SearchPlan search_plan_of(const SearchOptions& options) {
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
  plan.sources = beginning_sources(options, *plan.kernel);
  // The run from which it begins has every family, as `axiscert run` does, unless some are given.
  plan.first_queries = is_first ? first_queries : first_by_oracles;
  if (options.first_queries != 0) plan.first_queries = options.first_queries;
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

}  // namespace axiscert
