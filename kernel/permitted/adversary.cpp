#include "kernel/permitted/adversary.h"

#include <bit>

namespace axiscert::permitted {

// Contact by clauses comes one way: a comparison of each clause fails, whichever.
Adversary::Adversary(const Predicate& predicate, const Recording& recording, Verdict wished, std::size_t tries)
    : predicate_(predicate), recording_(recording), wished_(wished), evaluation_(recording.graph), tries_(tries) {
  const bool separated = wished == Verdict::separated;
  for (std::size_t i = 0; i < recording.paths.size(); ++i) {
    const Path& path = recording.paths[i];
    if (path.separates == separated) ways_.push_back({path.holding, path.failing, i, {}});
  }
  if (recording.paths.empty() && separated) {
    for (const PredicateClause& clause : predicate.clauses) ways_.push_back({clause.comparisons, 0, 0, {}});
  } else if (recording.paths.empty()) {
    ways_.push_back({});
  }
  for (Way& way : ways_) {
    const ComparisonBits own = way.holding | way.failing;
    way.kept = kept_below(own != 0 ? own : all_comparisons(predicate));
  }
}

std::vector<std::uint32_t> Adversary::kept_below(ComparisonBits comparisons) const {
  const auto& nodes = recording_.graph.nodes();
  std::vector<bool> below(nodes.size());
  for (std::size_t i = 0; i < recording_.sides.size(); ++i) {
    if (!has_bit(comparisons, i)) continue;
    below[recording_.sides[i].first.node] = below[recording_.sides[i].second.node] = true;
  }
  std::vector<std::uint32_t> found;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (!below[i]) continue;
    for (const Value child : nodes[i].children) below[child.node] = true;
    for (const Factoring& factoring : nodes[i].factorings) below[factoring.product.node] = true;
    if (nodes[i].kind == Kind::kept) found.insert(found.begin(), static_cast<std::uint32_t>(i));
  }
  return found;
}

bool Adversary::can_be(std::size_t comparison, bool holding) {
  auto [lhs, rhs] = recording_.sides[comparison];
  const bool nonstrict = has_bit(recording_.nonstrict, comparison);
  // Quickly, where the sides are far from each other.
  const Outer left = evaluation_.outer_of(lhs), right = evaluation_.outer_of(rhs);
  const double apart = left.middle - right.middle, most = (left.radius + right.radius) * (1 + 0x1p-46);
  if (apart > most) return holding;
  if (-apart > most) return !holding;
  const Reach l = evaluation_.of(lhs), r = evaluation_.of(rhs);
  if (holding) return nonstrict ? l.greatest >= r.least : l.greatest > r.least;
  return nonstrict ? l.least < r.greatest : l.least <= r.greatest;
}

bool Adversary::is_open(const Way& way) {
  if ((way.holding | way.failing) == 0) {
    for (const PredicateClause& clause : predicate_.clauses) {
      bool may_fail = false;
      for (ComparisonBits left = clause.comparisons; left != 0 && !may_fail; left &= left - 1)
        may_fail = can_be(static_cast<std::size_t>(std::countr_zero(left)), false);
      if (!may_fail) return false;
    }
    return true;
  }
  for (const bool holding : {true, false}) {
    for (ComparisonBits left = holding ? way.holding : way.failing; left != 0; left &= left - 1) {
      if (!can_be(static_cast<std::size_t>(std::countr_zero(left)), holding)) return false;
    }
  }
  return true;
}

// With a value for each barrier no more can be than with any: so they are fixed one by one, to each of their ends,
// while the way stays open.
bool Adversary::is_open_with_one_value_each(const Way& way, std::size_t first) {
  if (left_ == 0) return false;
  if (!is_open(way)) {
    --left_;
    return false;
  }
  for (std::size_t k = first; k < way.kept.size(); ++k) {
    const Reach reach = evaluation_.of({way.kept[k]});
    if (reach.least == reach.greatest) continue;
    for (const float end : {reach.greatest, reach.least}) {
      evaluation_.fix(way.kept[k], end);
      if (is_open_with_one_value_each(way, k + 1)) return true;
    }
    evaluation_.fix(way.kept[k], std::nullopt);
    return false;
  }
  return true;
}

Verdict Adversary::answer(std::span<const float> query) {
  evaluation_.start(query);
  for (const Way& way : ways_) {
    left_ = tries_;
    if (!is_open_with_one_value_each(way, 0)) continue;
    path_ = way.path;
    return wished_;
  }
  return wished_ == Verdict::separated ? Verdict::contact : Verdict::separated;
}

}  // namespace axiscert::permitted
