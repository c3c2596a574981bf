// A small plan, for tests.
#pragma once

#include "fuzz/campaign/stretch.h"
#include "kernel/base/error.h"

namespace axiscert {

inline Plan small_plan(const std::vector<std::string>& kernels, const std::vector<std::string>& families,
                       std::uint64_t trials) {
  Plan plan;
  for (const std::string& id : kernels) plan.answerers.kernels.push_back(&find_kernel(id));
  for (const std::string& name : families) plan.questions.sources.push_back(family_source(find_family(name)));
  plan.questions.precisions = {Precision::binary32, Precision::binary64};
  plan.questions.trials = [trials](const Source&, Precision) { return trials; };
  plan.running.target = resolve_target("auto");
  return plan;
}

}  // namespace axiscert
