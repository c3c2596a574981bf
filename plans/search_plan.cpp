#include "plans/search_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/confirm/record.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/source.h"
#include "fuzz/search/method.h"
#include "fuzz/search/numbers.h"
#include "kernel/base/error.h"
#include "kernel/registry/self_check.h"
#include "plans/notices.h"
#include "plans/predicate_options.h"
#include "plans/run_plan.h"

namespace axiscert {
namespace {

std::size_t parse_comparison(const std::string& given, const Predicate& predicate) {
  std::vector<std::string_view> known;
  for (std::size_t k = 0; k < predicate.comparisons.size(); ++k) {
    if (predicate.comparisons[k].name == given) return k;
    known.push_back(predicate.comparisons[k].name);
  }
  throw Error(fmt::format("--comparison {}: {}", given, unknown_name("comparison", "comparisons", given, known)));
}

// In the order of the aims, each once.
std::vector<std::string> parse_what(const std::vector<std::string>& given, const Kernel& kernel) {
  std::vector<std::string_view> known = {verdict_word};
  for (const Aim& aim : number_aims(kernel)) known.push_back(word(fault_of(aim)));
  for (const std::string& one : given) {
    if (std::ranges::find(known, one) == known.end())
      throw Error(fmt::format("--what {}: {}", one, unknown_name("aim", "aims of this kernel", one, known)));
  }
  std::vector<std::string> what;
  for (const std::string_view one : known) {
    if (std::ranges::find(given, one) != given.end()) what.emplace_back(one);
  }
  return what;
}

const Kernel& kernel_of(const SearchOptions& options) {
  const Kernel& kernel =
      options.kernel.empty() ? default_kernel(predicate_given(options.predicate)) : find_kernel(options.kernel);
  predicate_of_kernels(options.predicate, {&kernel});
  require_moves("search", *kernel.predicate, kernel.entry);
  return kernel;
}

// The families that islands start from: those that were given, or the defaults.
std::vector<SourcePtr> beginning_sources(const SearchOptions& options, const Kernel& kernel,
                                         const SearchDefaults& defaults) {
  const std::vector<std::string>& names = options.families.empty() ? defaults.families : options.families;
  std::vector<SourcePtr> sources;
  const std::vector<std::string> all = {"all"};
  for (const Family* family : families_named(names.empty() ? all : names, *kernel.predicate, kernel.entry))
    sources.push_back(family_source(*family));
  require_one_predicate({&kernel}, sources);
  return sources;
}

}  // namespace

SearchPlan search_plan_of(const SearchOptions& options) {
  SearchPlan plan;
  plan.kernel = &kernel_of(options);
  const SearchMethod& method = search_method_of(*plan.kernel->predicate);
  const SearchDefaults& defaults = method.defaults();
  require_loaded(*plan.kernel);
  print_first_look(*plan.kernel);
  plan.precision = parse_precision(options.precision);
  if (!plan.kernel->has(plan.precision)) {
    throw Error(fmt::format("--precision {}: kernel {} does not exist in it", options.precision, plan.kernel->id));
  }
  if (!options.comparisons.empty())
    require_capability(has_error_aims, "--comparison", *plan.kernel->predicate, plan.kernel->entry);
  for (const std::string& given : options.comparisons) {
    const std::size_t which = parse_comparison(given, *plan.kernel->predicate);
    const auto& so_far = plan.comparisons;
    if (std::find(so_far.begin(), so_far.end(), which) == so_far.end()) plan.comparisons.push_back(which);
  }
  if (!plan.comparisons.empty() && method.aims(*plan.kernel, plan.comparisons).empty()) {
    throw Error(
        fmt::format("--comparison: kernel {} does not show the computed sides of its own formulae", plan.kernel->id));
  }
  std::sort(plan.comparisons.begin(), plan.comparisons.end());
  plan.what = parse_what(options.what, *plan.kernel);
  plan.sources = beginning_sources(options, *plan.kernel, defaults);
  // The run from which it begins has every family, as `axiscert run` does, unless some are given.
  plan.first_queries = options.first_queries != 0 ? options.first_queries : defaults.first_queries;
  if (!options.families.empty()) plan.first_sources = plan.sources;
  else
    for (const Family* family : families_of(*plan.kernel->predicate, plan.kernel->entry))
      plan.first_sources.push_back(family_source(*family));
  plan.seed = options.seed;
  plan.seconds = options.seconds;
  plan.evaluations = options.evaluations;
  if (!plan.seconds && !plan.evaluations) plan.evaluations = defaults.evaluations;
  plan.target = resolve_target(options.target);
  plan.threads = threads_of(options.threads);
  return plan;
}

}  // namespace axiscert
