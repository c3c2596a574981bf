// The valid queries of a batch of sphere-triangle, with the exact sides of every set of formulae.
#pragma once

#include "exact/sphere_triangle/asked_sphere_triangle.h"
#include "fuzz/instruments/for_each_judged.h"

namespace axiscert {

// All queries of a file, whatever number the caller chose.
inline void take_whole_files(JudgedPlan& plan, Precision precision) {
  for (std::size_t i = 0; i < plan.sources.size(); ++i)
    plan.trials[i] = plan.sources[i]->fixed_size(precision).value_or(plan.trials[i]);
}

// Calls visit(i, asked) for each, whose truth is known; returns how many of the batch are invalid. Throws
// OracleDisagreement.
template <class Real, class Visit>
std::uint64_t for_each_valid(JudgedBatch<Real>& batch, const Visit& visit) {
  std::uint64_t invalid = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    AskedSphereTriangle<Real> asked(batch[i], batch.opinion(i));
    batch.count_progress();
    if (asked.truth().verdict == Verdict::invalid) ++invalid;
    else visit(i, asked);
  }
  return invalid;
}

}  // namespace axiscert
