// The valid queries of a batch of sphere-triangle, with the exact sides of every set of formulae.
#pragma once

#include "exact/sphere_triangle/claims/claim.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "fuzz/judging/judged_batch.h"

namespace axiscert {

// Calls visit(i, query, truth, claims) for each; returns how many of the batch are invalid. Throws OracleDisagreement.
template <class Real, class Visit>
std::uint64_t for_each_valid(JudgedBatch<Real>& batch, const Visit& visit) {
  std::uint64_t invalid = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Query<Real> q = batch[i];
    batch.count_progress();
    const ExactTruth truth = exact_truth(q, batch.opinion(i) == Opinion::second);
    if (!truth.formula) {
      ++invalid;
      continue;
    }
    Claims<Real> claims(q, *truth.formula);
    visit(i, q, truth, claims);
  }
  return invalid;
}

}  // namespace axiscert
