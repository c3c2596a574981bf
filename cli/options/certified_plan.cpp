#include "cli/options/certified_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/options/predicate_options.h"
#include "fuzz/certify/effort.h"
#include "fuzz/confirm/finding_record.h"
#include "fuzz/files/corpus.h"

namespace axiscert {

namespace {

std::vector<std::string> yardsticks_of(const Predicate& predicate, std::size_t entry, const std::string& kernel) {
  std::vector<std::string> ids = {default_kernel(predicate, entry).id};
  if (!predicate.certified.empty()) ids.emplace_back(predicate.certified);
  std::erase(ids, kernel);
  std::erase_if(ids, [&](const std::string& id) { return find_kernel(id).entry != entry; });
  return ids;
}

// `kernels`: of this predicate and entry.
RunOptions certified_options(const CertifiedRun& run, const Predicate& predicate, std::size_t entry,
                             const std::vector<std::string>& kernels, bool is_slow) {
  RunOptions options;
  options.kernels = kernels;
  options.families = {"all"};
  options.meshes = run.meshes;
  const auto is_of_kernel = [&](const CorpusEntry& known) {
    return known.stored.predicate == &predicate && known.stored.entry == entry;
  };
  if (std::ranges::any_of(read_corpus(default_corpus_folder()), is_of_kernel)) options.corpus = default_corpus_folder();
  options.seed = run.seed;
  options.effort = run.effort;
  options.is_slow = is_slow;
  options.threads = run.threads;
  return options;
}

}  // namespace

PlanFile certified_plan(const CertifiedRun& run) {
  const Kernel& kernel = find_kernel(run.kernel);
  require_loaded(kernel);
  parse_effort(run.effort);
  std::vector<std::string> kernels = {run.kernel};
  for (const std::string& id : yardsticks_of(*kernel.predicate, kernel.entry, kernel.id)) kernels.push_back(id);
  return plan_file_of(certified_options(run, *kernel.predicate, kernel.entry, kernels, !kernel.file.empty()),
                      std::nullopt);
}

PlanOfAbsent certified_plan_of(const CertifiedRun& run, const AbsentKernel& kernel) {
  const std::vector<std::string> yardsticks = yardsticks_of(*kernel.predicate, kernel.entry, run.kernel);
  std::vector<std::string> run_here = yardsticks;
  if (run_here.empty())
    run_here = {default_kernel(*kernel.predicate, kernel.entry).id};  // in place of the one that is absent
  Plan plan = plan_of(certified_options(run, *kernel.predicate, kernel.entry, run_here, kernel.is_slow));
  plan.questions.precisions.clear();
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const bool has = std::ranges::find(kernel.precisions, precision) != kernel.precisions.end();
    if (has || std::ranges::any_of(yardsticks, [&](const std::string& id) { return find_kernel(id).has(precision); }))
      plan.questions.precisions.push_back(precision);
  }
  Json json = json_of(plan_record(plan));
  json["kernels"] = yardsticks;
  json["kernels"].insert(json["kernels"].begin(), run.kernel);
  return {std::move(plan.questions), std::move(json)};
}

}  // namespace axiscert
