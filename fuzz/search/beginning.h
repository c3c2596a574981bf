// The finds of a short run of a search's kernel: a search begins from it and reports no less.
#pragma once

#include <atomic>
#include <vector>

#include "fuzz/search/search.h"

namespace axiscert {

template <class Real>
struct Beginning {
  std::vector<std::vector<Numbers<Real>>> found;  // by aim
  LookedAt looked_at;                             // without the first fault, which a run has in its record
};

// For each aim the queries that showed most of it, in the order of aims, by a run of plan.first_queries queries of each
// of plan.first_sources: the deepest wrong verdicts and, for a comparison, its largest errors; for the critical radius,
// the deepest wrong verdicts too. At most Pool::capacity each, the most severe first; none for a goal of range, which a
// run does not measure. They are as the sources made them, and not confirmed. Depends on the plan alone, unless
// `interrupted`, which is polled.
template <class Real>
Beginning<Real> first_found(const SearchPlan& plan, const std::vector<Aim>& aims, const std::atomic<bool>& interrupted);

}  // namespace axiscert
