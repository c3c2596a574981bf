#include "fuzz/search/island.h"

#include <algorithm>

#include "fuzz/search/moves.h"

namespace axiscert {
namespace {

// The last part, 1 / polish_share, of an island's evaluations, in which only single numbers change, by a few ulps.
constexpr std::uint64_t polish_share = 8;

template <class Real>
Numbers<Real> child(const Guide<Real>& guide, const Aim& aim, Dice& random, const Numbers<Real>& parent,
                    const Numbers<Real>& other, bool is_polishing) {
  Numbers<Real> q = parent;
  if (is_polishing) {
    const auto count = 1 + random.below(2);
    for (std::uint64_t i = 0; i < count; ++i) {
      Real& x = q[random.below(q.size())];
      x = moved_by_ulps(x, random.integer(-64, 64));
    }
  } else if (!guide.step(aim, random, q)) {
    do move(random, guide.shape(), q, other);
    while (random.below(4) == 0);
  }
  guide.settle(q);
  return q;
}

template <class Real>
void sort_best_first(std::vector<ScoredQuery<Real>>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& x, const auto& y) { return x.score > y.score; });
}

}  // namespace

template <class Real>
std::vector<ScoredQuery<Real>> climb(Guide<Real>& guide, const Aim& aim, Dice& random,
                                     const std::vector<Numbers<Real>>& starts, std::uint64_t evaluations,
                                     const ShowAnswers<Real>& show) {
  QueryBatch<Real> batch(walkers * children, guide.shape().numbers);
  std::vector<double> scores;
  std::vector<Verdict> said;
  const auto evaluate = [&] {
    guide.evaluate(aim, batch, scores, said);
    if (show) show(batch, said);
  };
  std::vector<ScoredQuery<Real>> found;
  for (Numbers<Real> q : starts) {
    guide.settle(q);
    batch.push_back(q);
  }
  evaluate();
  for (std::size_t i = 0; i < starts.size(); ++i) found.push_back({batch[i], scores[i]});
  sort_best_first(found);
  found.resize(std::min(found.size(), walkers));
  for (std::uint64_t done = batch.size(); done + batch.capacity() <= evaluations; done += batch.capacity()) {
    const bool is_polishing = done >= evaluations - evaluations / polish_share;
    batch.clear();
    for (const ScoredQuery<Real>& parent : found) {
      for (std::size_t i = 0; i < children; ++i) {
        const Numbers<Real>& other = found[random.below(found.size())].query;
        batch.push_back(child(guide, aim, random, parent.query, other, is_polishing));
      }
    }
    evaluate();
    for (std::size_t w = 0; w < found.size(); ++w) {
      const auto first = scores.begin() + static_cast<std::ptrdiff_t>(w * children);
      const auto best = std::max_element(first, first + children);
      // An equal score is accepted as well, so that plateaus are crossed.
      if (*best >= found[w].score) found[w] = {batch[static_cast<std::size_t>(best - scores.begin())], *best};
    }
  }
  sort_best_first(found);
  return found;
}

template std::vector<ScoredQuery<float>> climb(Guide<float>&, const Aim&, Dice&, const std::vector<Numbers<float>>&,
                                               std::uint64_t, const ShowAnswers<float>&);
template std::vector<ScoredQuery<double>> climb(Guide<double>&, const Aim&, Dice&, const std::vector<Numbers<double>>&,
                                                std::uint64_t, const ShowAnswers<double>&);

}  // namespace axiscert
