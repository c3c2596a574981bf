#include "kernel/permitted/lanes.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <span>

#include "kernel/base/environment.h"
#include "kernel/base/error.h"
#include "kernel/permitted/reach.h"
#include "kernel/permitted/permissions.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/permitted/lanes.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/lanes-inl.h"
#include "kernel/permitted/around-inl.h"
#include "kernel/permitted/ends-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::permitted {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using axiscert::HWY_NAMESPACE::bits_of_mask;
using axiscert::HWY_NAMESPACE::for_each_vector;

class Queries {
 public:
  // As many as there are lanes, from `first` on.
  Queries(const AdversaryInLanes::Plan& plan, AdversaryInLanes::Memory& memory, AdversaryInLanes::Block& block,
          const QueryColumns<float>& batch, std::size_t first)
      : plan_(plan), graph_(plan.recording.graph), memory_(memory), block_(block) {
    if (block.plan != plan.number) {
      block.plan = plan.number;
      block.columns.assign(plan.above.size() * lanes, 0);
      block.greatest.resize(graph_.nodes().size() * lanes);
      block.negated_least.resize(block.greatest.size());
      block.middle.resize(block.greatest.size());
      block.radius.resize(block.greatest.size());
      block.is_known.assign(graph_.nodes().size(), 0);
      block.is_around_known = block.is_known;
      block.known = block.around_known = 0;
    }
    for (std::size_t k = 0; k < plan.above.size(); ++k) {
      float* column = &block.columns[k * lanes];
      if (std::memcmp(column, batch.column[k] + first, lanes * sizeof(float)) == 0) continue;
      std::memcpy(column, batch.column[k] + first, lanes * sizeof(float));
      for (const std::uint32_t node : plan.above[k]) block.is_known[node] = block.is_around_known[node] = 0;
      block.known &= ~plan.comparisons_above[k];
      block.around_known &= ~plan.comparisons_above[k];
    }
  }

  // The lanes that `wished` can be in, among `asked`.
  std::uint64_t open(std::uint64_t asked) {
    std::uint64_t found = 0;
    std::array<std::uint64_t, most_comparisons + 1> left;  // by the number of decisions
    left[0] = asked;
    for (std::size_t w = 0; w < plan_.ways.size();) {
      const auto& [decisions, shared] = plan_.ways[w];
      std::size_t k = shared;
      for (; k < decisions.size() && (left[k] & ~found) != 0; ++k)
        left[k + 1] = left[k] & can_be(decisions[k].first, decisions[k].second, left[k] & ~found);
      if (k == decisions.size()) found |= left[k];
      if (found == asked) return found;
      // No lane is left in those that begin with as many decisions.
      do ++w;
      while (w < plan_.ways.size() && plan_.ways[w].shared >= k);
    }
    if (plan_.clauses.empty()) return found;
    for (const ComparisonBits clause : plan_.clauses) {
      std::uint64_t fail = 0;
      for (ComparisonBits bits = clause; bits != 0 && fail != asked; bits &= bits - 1)
        fail |= asked & can_be(static_cast<std::size_t>(std::countr_zero(bits)), false, asked & ~fail);
      if ((asked = fail) == 0) break;
    }
    return asked;
  }

 private:
  Ends known(Value v) const {
    const Ends ends{hn::LoadU(d, &block_.greatest[v.node * lanes]),
                    hn::LoadU(d, &block_.negated_least[v.node * lanes])};
    return v.is_negative ? negative(ends) : ends;
  }
  // The lanes in which a comparison can hold, or fail, right in those that are asked.
  std::uint64_t can_be(std::size_t i, bool holding, std::uint64_t asked) {
    // Quickly, where the sides are far from each other.
    if (!has_bit(block_.known, i) && graph_.permissions().faithful) {
      put_surely(i);
      if ((asked & ~(block_.surely_holds[i] | block_.surely_fails[i])) == 0)
        return holding ? block_.surely_holds[i] : block_.surely_fails[i];
    }
    if (!has_bit(block_.known, i)) {
      for (const std::uint32_t node : plan_.below[i]) {
        if (block_.is_known[node] != 0) continue;
        const Ends ends = found(node);
        hn::StoreU(ends.greatest, d, &block_.greatest[node * lanes]);
        hn::StoreU(ends.negated_least, d, &block_.negated_least[node * lanes]);
        block_.is_known[node] = 1;
      }
      const Ends l = known(plan_.recording.sides[i].first), r = known(plan_.recording.sides[i].second);
      const bool nonstrict = has_bit(plan_.recording.nonstrict, i);
      const V least_r = hn::Neg(r.negated_least), least_l = hn::Neg(l.negated_least);
      block_.holds[i] = bits_of_mask(d, nonstrict ? hn::Ge(l.greatest, least_r) : hn::Gt(l.greatest, least_r));
      block_.fails[i] = bits_of_mask(d, nonstrict ? hn::Lt(least_l, r.greatest) : hn::Le(least_l, r.greatest));
      block_.known |= one_bit<ComparisonBits>(i);
    }
    return holding ? block_.holds[i] : block_.fails[i];
  }

  void put_surely(std::size_t i) {
    if (has_bit(block_.around_known, i)) return;
    const auto known_around = [&](std::uint32_t node) HWY_ATTR {
      return Around<V>{hn::LoadU(d, &block_.middle[node * lanes]), hn::LoadU(d, &block_.radius[node * lanes])};
    };
    const AroundNode<D, decltype(known_around)> around(graph_, known_around);
    for (const std::uint32_t number : plan_.as_written[i]) {
      if (block_.is_around_known[number] != 0) continue;
      const Node& node = graph_.nodes()[number];
      const V column = node.kind == Kind::input
                           ? hn::LoadU(d, &block_.columns[static_cast<std::size_t>(node.payload) * lanes])
                           : hn::Zero(d);
      const Around<V> found = around.of(node, column);
      hn::StoreU(found.middle, d, &block_.middle[number * lanes]);
      hn::StoreU(found.radius, d, &block_.radius[number * lanes]);
      block_.is_around_known[number] = 1;
    }
    const auto [lhs, rhs] = plan_.recording.sides[i];
    const Around<V> l = around.value(lhs), r = around.value(rhs);
    const V apart = hn::Add(l.radius, r.radius);  // differences rounded downward are compared with it
    block_.surely_holds[i] = bits_of_mask(d, hn::Gt(hn::Neg(hn::Sub(r.middle, l.middle)), apart));
    block_.surely_fails[i] = bits_of_mask(d, hn::Gt(hn::Neg(hn::Sub(l.middle, r.middle)), apart));
    block_.around_known |= one_bit<ComparisonBits>(i);
  }

  Ends found(std::uint32_t number) {
    const Node& node = graph_.nodes()[number];
    switch (node.kind) {
      case Kind::input: {
        const V x = hn::LoadU(d, &block_.columns[static_cast<std::size_t>(node.payload) * lanes]);
        const Ends ends{x, hn::Neg(x)};
        return flushed(graph_.permissions(), where(is_finite(ends), ends));
      }
      case Kind::constant: {
        const V x = hn::Set(d, static_cast<float>(node.payload));
        return {x, hn::Neg(x)};
      }
      case Kind::magnitude: {
        const Ends a = known(node.children[0]);
        const V x = hn::Abs(a.greatest), y = hn::Abs(a.negated_least);
        return {hn::Max(x, y), hn::Neg(hn::Min(x, y))};
      }
      case Kind::least: {
        const Ends a = known(node.children[0]), b = known(node.children[1]);
        return {hn::Min(a.greatest, b.greatest), hn::Max(a.negated_least, b.negated_least)};
      }
      case Kind::greatest: {
        const Ends a = known(node.children[0]), b = known(node.children[1]);
        return {hn::Max(a.greatest, b.greatest), hn::Min(a.negated_least, b.negated_least)};
      }
      case Kind::kept:
      case Kind::reciprocal:
        return known(node.children[0]);
      case Kind::quotient: {
        const Ends a = known(node.children[0]), b = known(node.children[1]),
                   q = quotient_of(graph_.permissions(), a, b);
        return where(hn::And(hn::And(is_finite(a), is_finite(b)), is_finite(q)), q);
      }
      case Kind::sum:
      case Kind::product:
        return subsets(number);
    }
    return {hn::Zero(d), hn::Zero(d)};
  }

  // As Evaluation::subsets. What is indeterminate in a subset is so in every greater one, and in the node.
  Ends subsets(std::uint32_t number) {
    const Node& node = graph_.nodes()[number];
    const bool is_sum = node.kind == Kind::sum;
    const V none = hn::Set(d, -infinity);
    M is_determinate = hn::Eq(none, none), has_sign = is_determinate, is_negative = hn::Ne(none, none);
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const Ends child = known(node.children[i]);
      is_determinate = hn::And(is_determinate, is_finite(child));
      has_sign = hn::And(has_sign, hn::Le(hn::Min(child.greatest, child.negated_least), hn::Zero(d)));
      is_negative = hn::Xor(is_negative, hn::Gt(child.negated_least, child.greatest));
      put(std::uint32_t{1} << i, child);
    }
    if (is_sum)
      return every_split(number, is_determinate,
                         [&](std::uint32_t sub, std::uint32_t rest) HWY_ATTR { return sum_of(at(sub), at(rest)); });
    const std::uint32_t divisors = plan_.divisors[number];
    if (divisors == 0 && hn::AllTrue(d, has_sign)) {
      // The sizes are multiplied, and the sign of all is that of their product.
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        const Ends child = at(std::uint32_t{1} << i);
        put(std::uint32_t{1} << i,
            {hn::Max(child.greatest, child.negated_least), hn::Min(child.greatest, child.negated_least)});
      }
      const Ends size = every_split(number, is_determinate, [&](std::uint32_t sub, std::uint32_t rest) HWY_ATTR {
        const Ends a = at(sub), b = at(rest);
        return Ends{hn::Mul(a.greatest, b.greatest), hn::Mul(a.negated_least, hn::Neg(b.negated_least))};
      });
      return {hn::IfThenElse(is_negative, size.negated_least, size.greatest),
              hn::IfThenElse(is_negative, size.greatest, size.negated_least)};
    }
    return every_split(number, is_determinate, [&](std::uint32_t sub, std::uint32_t rest) HWY_ATTR {
      if ((sub & ~divisors) == 0) std::swap(sub, rest);
      if ((rest & ~divisors) != 0) return product_of(at(sub), at(rest));
      const V none = hn::Set(d, -infinity);
      return std::has_single_bit(rest) ? quotient_of(graph_.permissions(), at(sub), at(rest))
                                       : Ends{none, none};  // one after the other
    });
  }
  Ends at(std::uint32_t mask) const {
    return {hn::LoadU(d, &memory_.greatest_of_subset[mask * lanes]),
            hn::LoadU(d, &memory_.negated_least_of_subset[mask * lanes])};
  }
  void put(std::uint32_t mask, const Ends& ends) {
    hn::StoreU(ends.greatest, d, &memory_.greatest_of_subset[mask * lanes]);
    hn::StoreU(ends.negated_least, d, &memory_.negated_least_of_subset[mask * lanes]);
  }
  // Equal children are taken first to last: a set with another of them is as the one with these.
  template <class Operation>
  AXISCERT_INLINE Ends every_split(std::uint32_t number, M is_determinate, Operation&& operation) {
    const Node& node = graph_.nodes()[number];
    const std::uint32_t count = std::uint32_t{1} << node.children.size(), divisors = plan_.divisors[number],
                        repeated = plan_.repeated[number];
    const auto other_first = [&](std::uint32_t mask) { return mask & repeated & ~(mask << 1); };
    const V none = hn::Set(d, -infinity);
    Ends ends{none, none};
    for (std::uint32_t mask = 3; mask < count; ++mask) {
      if (std::has_single_bit(mask) || (mask & ~divisors) == 0) continue;
      if (const std::uint32_t other = other_first(mask); other != 0) {
        const std::uint32_t one = other & (~other + 1);
        put(mask, at(mask ^ one ^ one >> 1));
        continue;
      }
      ends = {none, none};
      for_each_split(mask, [&](std::uint32_t sub, std::uint32_t rest) HWY_ATTR {
        if (other_first(sub) == 0) ends = joined(ends, operation(sub, rest));
      });
      ends = flushed(graph_.permissions(), ends);
      for (const Factoring& factoring : node.factorings) {
        if (factoring.mask != mask) continue;
        const Ends product = known(factoring.product);
        is_determinate = hn::And(is_determinate, is_finite(product));
        ends = joined(ends, product);
      }
      is_determinate = hn::And(is_determinate, is_finite(ends));
      put(mask, ends);
    }
    return where(is_determinate, ends);
  }

  const AdversaryInLanes::Plan& plan_;
  const Graph& graph_;
  AdversaryInLanes::Memory& memory_;
  AdversaryInLanes::Block& block_;
};

std::size_t lane_count() { return lanes; }
void ask_lanes(const AdversaryInLanes::Plan& plan, AdversaryInLanes::Memory& memory, const QueryColumns<float>& batch,
               std::uint8_t* can_be) {
  for_each_vector<float>(batch, [&](const QueryColumns<float>& from, std::size_t at, std::size_t i, std::size_t count) {
    AdversaryInLanes::Block& block = memory.blocks[i / lanes % memory.blocks.size()];
    const std::uint64_t open = Queries(plan, memory, block, from, at).open((std::uint64_t{1} << count) - 1);
    for (std::size_t k = 0; k < count; ++k) can_be[i + k] = has_bit(open, k) ? 1 : 0;
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::permitted
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert::permitted {
HWY_EXPORT(lane_count);
HWY_EXPORT(ask_lanes);

namespace {

template <class Use>
void for_each_operand(const Node& node, bool is_factored, Use&& use) {
  for (const Value child : node.children) use(child);
  if (!is_factored) return;
  for (const Factoring& factoring : node.factorings) use(factoring.product);
}

std::vector<std::uint32_t> numbers_of(const std::vector<bool>& among) {
  std::vector<std::uint32_t> numbers;
  for (std::size_t i = 0; i < among.size(); ++i) {
    if (among[i]) numbers.push_back(static_cast<std::uint32_t>(i));
  }
  return numbers;
}

std::atomic<std::uint64_t> plans = 0;

}  // namespace

AdversaryInLanes::AdversaryInLanes(const Predicate& predicate, std::size_t entry, const Recording& recording,
                                   Verdict wished)
    : plan_{recording, ++plans} {
  if (!covers(recording.graph.permissions())) throw HarnessFault("what is fused and rounded to nearest has no lanes");
  const bool separated = wished == Verdict::separated;
  const auto put = [&](const std::vector<std::pair<std::size_t, bool>>& decisions) {
    std::size_t shared = 0;
    if (!plan_.ways.empty()) {
      const auto& before = plan_.ways.back().decisions;
      const auto [first, _] = std::mismatch(decisions.begin(), decisions.end(), before.begin(), before.end());
      shared = static_cast<std::size_t>(first - decisions.begin());
    }
    if (decisions.size() > most_comparisons) throw HarnessFault("a way of too many decisions");
    plan_.ways.push_back({decisions, shared});
  };
  for (const Path& path : recording.paths) {
    if (path.separates == separated) put(path.decisions);
  }
  for (const PredicateClause& clause : predicate.clauses) {
    if (!recording.paths.empty()) break;
    if (!separated) {
      plan_.clauses.push_back(clause.comparisons);
      continue;
    }
    std::vector<std::pair<std::size_t, bool>> decisions;
    for (ComparisonBits bits = clause.comparisons; bits != 0; bits &= bits - 1)
      decisions.emplace_back(static_cast<std::size_t>(std::countr_zero(bits)), true);
    put(decisions);
  }
  const std::vector<Node>& nodes = recording.graph.nodes();
  for (const Node& node : nodes) {
    plan_.divisors.push_back(divisors_of(recording.graph, node));
    std::uint32_t& repeated = plan_.repeated.emplace_back(0);
    for (std::size_t i = 1; i < node.children.size(); ++i)
      repeated |= bit_if<std::uint32_t>(node.children[i] == node.children[i - 1], i);
    plan_.most_children = std::max(plan_.most_children, node.children.size());
  }
  for (const auto& [lhs, rhs] : recording.sides) {
    for (const bool is_factored : {true, false}) {
      std::vector<bool> needed(nodes.size());
      needed[lhs.node] = needed[rhs.node] = true;
      for (std::size_t i = nodes.size(); i-- > 0;) {
        if (needed[i]) for_each_operand(nodes[i], is_factored, [&](Value operand) { needed[operand.node] = true; });
      }
      (is_factored ? plan_.below : plan_.as_written).push_back(numbers_of(needed));
    }
  }
  for (std::size_t k = 0; k < predicate.entries[entry].columns.size(); ++k) {
    std::vector<bool> needs(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      needs[i] = nodes[i].kind == Kind::input && nodes[i].payload == static_cast<double>(k);
      for_each_operand(nodes[i], true, [&](Value operand) { needs[i] = needs[i] || needs[operand.node]; });
    }
    plan_.above.push_back(numbers_of(needs));
    ComparisonBits& comparisons = plan_.comparisons_above.emplace_back(0);
    for (std::size_t i = 0; i < recording.sides.size(); ++i) {
      const auto& [lhs, rhs] = recording.sides[i];
      comparisons |= bit_if<ComparisonBits>(needs[lhs.node] || needs[rhs.node], i);
    }
  }
}

void AdversaryInLanes::ask(const QueryColumns<float>& batch, std::uint8_t* can_be) const {
  static thread_local Memory memory;
  const std::size_t subsets = (std::size_t{1} << plan_.most_children) * HWY_DYNAMIC_DISPATCH(lane_count)();
  if (memory.greatest_of_subset.size() < subsets) {
    memory.greatest_of_subset.resize(subsets);
    memory.negated_least_of_subset.resize(subsets);
  }
  const bool is_upward = plan_.recording.graph.permissions().faithful;
  const FloatingEnvironment scope(is_upward ? Rounding::upward : Rounding::nearest, false);
  HWY_DYNAMIC_DISPATCH(ask_lanes)(plan_, memory, batch, can_be);
}

}  // namespace axiscert::permitted
#endif
