#include "cli/options/certified_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/options/test_options.h"
#include "fuzz/certify/effort.h"
#include "fuzz/confirm/finding_record.h"
#include "fuzz/files/corpus.h"

namespace axiscert {

std::vector<std::string> yardsticks_for(const Kernel& kernel) {
  std::vector<std::string> ids = {"published", "certified"};
  if (kernel.test != &first_test()) ids = {default_kernel(*kernel.test, kernel.entry).id};
  std::erase(ids, kernel.id);
  std::erase_if(ids, [&](const std::string& id) { return find_kernel(id).entry != kernel.entry; });
  return ids;
}

PlanFile certified_plan(const CertifiedRun& run) {
  const Kernel& kernel = find_kernel(run.kernel);
  require_loaded(kernel);
  parse_effort(run.effort);
  RunOptions options;
  options.kernels = {run.kernel};
  for (const std::string& id : yardsticks_for(kernel)) options.kernels.push_back(id);
  options.families = {"all"};
  options.meshes = run.meshes;
  const auto is_of_kernel = [&](const CorpusEntry& entry) {
    return entry.stored.test == kernel.test && entry.stored.entry == kernel.entry;
  };
  if (std::ranges::any_of(read_corpus(default_corpus_folder()), is_of_kernel)) options.corpus = default_corpus_folder();
  options.seed = run.seed;
  options.effort = run.effort;
  options.is_slow = !kernel.file.empty();
  options.threads = run.threads;
  return plan_file_of(options, std::nullopt);
}

}  // namespace axiscert
