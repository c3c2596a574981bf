#include "fuzz/search/island.h"

#include <algorithm>
#include <cmath>

#include "fuzz/search/moves.h"

namespace axiscert {
namespace {

// The last part, 1 / polish_share, of an island's evaluations, in which only single numbers change, by a few ulps.
constexpr std::uint64_t polish_share = 8;

// Moves one number to where the comparison's scale vanishes, by one Newton step, which is exact if the margin is affine
// in the number; then by a few ulps.
template <class Real>
void step_to_cancellation(const Evaluator<Real>& evaluator, Comparison which, Dice& random, Query<Real>& q) {
  auto v = coordinates(q);
  Real& x = v[random.below(coordinate_count)];
  const Real start = x;
  const double here = evaluator.vanishing(which, q);
  const double by = start == 0 ? 0x1p-12 : double(start) * 0x1p-12;
  x = static_cast<Real>(start + by);
  const double slope = (evaluator.vanishing(which, from_coordinates(v)) - here) / (double(x) - double(start));
  const double root = start - here / slope;
  x = std::fabs(root) <= 4 ? moved_by_ulps(static_cast<Real>(root), random.integer(-3, 3)) : start;
  q = from_coordinates(v);
}

template <class Real>
Query<Real> child(const Evaluator<Real>& evaluator, const Aim& aim, Dice& random, const Query<Real>& parent,
                  const Query<Real>& other, bool is_polishing) {
  Query<Real> q = parent;
  if (is_polishing) {
    auto v = coordinates(q);
    const auto count = 1 + random.below(2);
    for (std::uint64_t i = 0; i < count; ++i) {
      Real& x = v[random.below(coordinate_count)];
      x = moved_by_ulps(x, random.integer(-64, 64));
    }
    q = from_coordinates(v);
  } else if (aim.goal == Goal::relative_error && random.below(8) == 0) {
    step_to_cancellation(evaluator, aim.which, random, q);
  } else {
    do move(random, q, other);
    while (random.below(4) == 0);
  }
  settle(q);
  return q;
}

template <class Real>
void best_first(std::vector<ScoredQuery<Real>>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& x, const auto& y) { return x.score > y.score; });
}

}  // namespace

template <class Real>
std::vector<ScoredQuery<Real>> climb(Evaluator<Real>& evaluator, const Aim& aim, Dice& random,
                                     const std::vector<Query<Real>>& starts, std::uint64_t evaluations) {
  QueryBatch<Real> batch(walkers * children, coordinate_count);
  std::vector<double> scores;
  std::vector<ScoredQuery<Real>> found;
  for (Query<Real> q : starts) {
    settle(q);
    batch.push_back(q);
  }
  evaluator.evaluate(aim, batch, scores);
  for (std::size_t i = 0; i < starts.size(); ++i) found.push_back({batch[i], scores[i]});
  best_first(found);
  found.resize(std::min(found.size(), walkers));
  for (std::uint64_t done = batch.size(); done + batch.capacity() <= evaluations; done += batch.capacity()) {
    const bool is_polishing = done >= evaluations - evaluations / polish_share;
    batch.clear();
    for (const ScoredQuery<Real>& parent : found) {
      for (std::size_t i = 0; i < children; ++i) {
        const Query<Real>& other = found[random.below(found.size())].query;
        batch.push_back(child(evaluator, aim, random, parent.query, other, is_polishing));
      }
    }
    evaluator.evaluate(aim, batch, scores);
    for (std::size_t w = 0; w < found.size(); ++w) {
      const auto first = scores.begin() + static_cast<std::ptrdiff_t>(w * children);
      const auto best = std::max_element(first, first + children);
      // An equal score is accepted as well, so that plateaus are crossed.
      if (*best >= found[w].score) found[w] = {batch[static_cast<std::size_t>(best - scores.begin())], *best};
    }
  }
  best_first(found);
  return found;
}

template std::vector<ScoredQuery<float>> climb(Evaluator<float>&, const Aim&, Dice&, const std::vector<Query<float>>&,
                                               std::uint64_t);
template std::vector<ScoredQuery<double>> climb(Evaluator<double>&, const Aim&, Dice&,
                                                const std::vector<Query<double>>&, std::uint64_t);

}  // namespace axiscert
