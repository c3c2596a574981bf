#include "fuzz/search/island.h"

#include <algorithm>

#include "fuzz/search/moves.h"

namespace axiscert {
namespace {

// The last part, 1 / polish_share, of an island's evaluations, in which only single numbers change, by a few ulps.
constexpr std::uint64_t polish_share = 8;

// The way of the last gain again, up to twice as far, or back by half.
template <class Real>
void go_on(Dice& random, Numbers<Real>& q, const Numbers<Real>& gained) {
  const auto exponent = static_cast<int>(random.integer(-2, 1));
  const Real by = std::ldexp(random.below(4) == 0 ? Real(-0.5) : Real(1), exponent);
  for (std::size_t k = 0; k < q.size(); ++k) q[k] += by * gained[k];
}

template <class Real>
Numbers<Real> child(const Guide<Real>& guide, const Aim& aim, Dice& random, const Numbers<Real>& parent,
                    const Numbers<Real>& gained, const Numbers<Real>& other, bool is_polishing) {
  Numbers<Real> q = parent;
  if (is_polishing) {
    const auto count = 1 + random.below(2);
    for (std::uint64_t i = 0; i < count; ++i) {
      Real& x = q[random.below(q.size())];
      x = moved_by_ulps(x, random.integer(-64, 64));
    }
  } else if (aim.goal == Goal::number && gained.size() != 0 && random.coin()) {
    go_on(random, q, gained);
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
  std::vector<Numbers<Real>> gained(found.size());  // by how much each changed when its score rose last
  for (std::uint64_t done = batch.size(); done + batch.capacity() <= evaluations; done += batch.capacity()) {
    const bool is_polishing = done >= evaluations - evaluations / polish_share;
    batch.clear();
    for (std::size_t w = 0; w < found.size(); ++w) {
      for (std::size_t i = 0; i < children; ++i) {
        const Numbers<Real>& other = found[random.below(found.size())].query;
        batch.push_back(child(guide, aim, random, found[w].query, gained[w], other, is_polishing));
      }
    }
    evaluate();
    for (std::size_t w = 0; w < found.size(); ++w) {
      const auto first = scores.begin() + static_cast<std::ptrdiff_t>(w * children);
      const auto best = std::max_element(first, first + children);
      // An equal score is accepted as well, so that plateaus are crossed.
      if (*best < found[w].score) continue;
      const Numbers<Real> q = batch[static_cast<std::size_t>(best - scores.begin())];
      if (*best > found[w].score) {
        gained[w] = q;
        for (std::size_t k = 0; k < q.size(); ++k) gained[w][k] -= found[w].query[k];
      }
      found[w] = {q, *best};
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
