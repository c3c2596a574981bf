// One island of a search: a few queries that climb side by side, are blended with each other, and are refined at the
// end.
#pragma once

#include <functional>

#include "fuzz/search/method.h"

namespace axiscert {

// A query and its estimated score.
template <class Real>
struct ScoredQuery {
  Numbers<Real> query;
  double score = 0;
};

inline constexpr std::size_t walkers = 8, children = 8;  // walkers climb; children of each per generation

// Called with every batch that was evaluated, and the kernel's verdicts on it.
template <class Real>
using ShowAnswers = std::function<void(const QueryBatch<Real>& batch, const std::vector<Verdict>& said)>;

// Climbs from the best of `starts`, at most walkers * children of them, with `evaluations` evaluations of queries, and
// returns the best query of each walker, best first. Depends on its arguments alone.
template <class Real>
std::vector<ScoredQuery<Real>> climb(Guide<Real>& guide, const Aim& aim, Dice& random,
                                     const std::vector<Numbers<Real>>& starts, std::uint64_t evaluations,
                                     const ShowAnswers<Real>& show = {});

}  // namespace axiscert
