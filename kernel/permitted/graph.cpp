#include "kernel/permitted/graph.h"

#include <algorithm>
#include <set>

#include "kernel/base/error.h"

namespace axiscert::permitted {
namespace {

// 3^10 splits: the sum of sums that have more terms together is grouped as it stands.
constexpr std::size_t most_terms = 10;

}  // namespace

thread_local Graph* RecordedNumber::graph = nullptr;
thread_local const std::function<bool(Value, Value, bool)>* RecordedNumber::decide = nullptr;

std::uint32_t Graph::made(Kind kind, double payload, std::vector<Value> children) {
  if (children.size() > most_children) throw HarnessFault("a sum or product of too many terms to try every grouping");
  if (kind == Kind::sum || kind == Kind::product) std::sort(children.begin(), children.end());  // both commute exactly
  const auto key = std::tuple(kind, payload, children);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  std::vector<Factoring> factorings;
  if (kind == Kind::sum && permissions_.factored) factorings = factorings_of(children);
  nodes_.push_back({kind, payload, std::move(children), std::move(factorings)});
  const auto number = static_cast<std::uint32_t>(nodes_.size() - 1);
  known_.emplace(key, number);
  return number;
}

Value Graph::sum(Value a, Value b) {
  if (is(a, 0)) return b;
  if (is(b, 0)) return a;
  std::vector<Value> terms;
  for (const Value v : {a, b}) {
    if (permissions_.reassociated && nodes_[v.node].kind == Kind::sum) {
      for (const Value child : nodes_[v.node].children) terms.push_back(v.is_negative ? -child : child);
    } else {
      terms.push_back(v);
    }
  }
  if (terms.size() > most_terms) terms = {a, b};
  return sum_of(std::move(terms));
}

// Only one of a sum and its negative is a node.
Value Graph::sum_of(std::vector<Value> terms) {
  std::sort(terms.begin(), terms.end());
  const bool is_negative = terms.front().is_negative;
  if (is_negative) {
    for (Value& term : terms) term = -term;
  }
  return {made(Kind::sum, 0, std::move(terms)), is_negative};
}

// A product by 0 or 1 is no operation: no rounding follows it.
Value Graph::product(Value a, Value b) {
  if (is(a, 0) || is(b, 1)) return a;
  if (is(b, 0) || is(a, 1)) return b;
  return product_of({a, b});
}

Value Graph::product_of(std::vector<Value> factors) {
  bool is_negative = false;
  std::vector<Value> all;
  for (const Value v : factors) {
    is_negative ^= v.is_negative;
    if (permissions_.reassociated && nodes_[v.node].kind == Kind::product) {
      all.insert(all.end(), nodes_[v.node].children.begin(), nodes_[v.node].children.end());
    } else {
      all.push_back({v.node});
    }
  }
  return {made(Kind::product, 0, std::move(all)), is_negative};
}

Value Graph::quotient(Value a, Value b) {
  const bool is_negative = a.is_negative != b.is_negative;
  Value found;
  if (permissions_.reassociated) found = product_of({{a.node}, {made(Kind::reciprocal, 0, {{b.node}})}});
  else found = {made(Kind::quotient, 0, {{a.node}, {b.node}})};
  return is_negative ? -found : found;
}

std::vector<Factoring> Graph::factorings_of(const std::vector<Value>& terms) {
  std::set<std::uint32_t> factors;
  for (const Value term : terms) {
    if (nodes_[term.node].kind != Kind::product) continue;
    for (const Value factor : nodes_[term.node].children) factors.insert(factor.node);
  }
  std::vector<Factoring> found;
  for (const std::uint32_t factor : factors) {
    std::vector<std::pair<std::uint32_t, Value>> rests;  // bit of the term, and what is left of it
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (nodes_[terms[i].node].kind != Kind::product) continue;
      std::vector<Value> left = nodes_[terms[i].node].children;
      const auto at = std::find(left.begin(), left.end(), Value{factor});
      if (at == left.end()) continue;
      left.erase(at);
      if (std::ranges::all_of(left, [&](Value v) { return is_divisor(v); })) continue;  // 1 / x is no operation here
      const Value rest = left.size() == 1 ? left.front() : product_of(std::move(left));
      rests.emplace_back(std::uint32_t{1} << i, terms[i].is_negative ? -rest : rest);
    }
    for (std::uint32_t chosen = 0; chosen < std::uint32_t{1} << rests.size(); ++chosen) {
      std::uint32_t mask = 0;
      std::vector<Value> left;
      for (std::size_t i = 0; i < rests.size(); ++i) {
        if (((chosen >> i) & 1) == 0) continue;
        mask |= rests[i].first;
        left.push_back(rests[i].second);
      }
      if (left.size() < 2) continue;
      std::size_t terms_inside = 0;
      for (const Value v : left) terms_inside += nodes_[v.node].kind == Kind::sum ? nodes_[v.node].children.size() : 1;
      if (terms_inside > most_terms) continue;
      Value inner = left.front();
      for (std::size_t i = 1; i < left.size(); ++i) inner = sum(inner, left[i]);
      std::vector<Value> insides = {inner};
      // A cofactor that is a product again is grouped with the factor in every way.
      for (const auto& [all, inside] : nodes_[inner.node].factorings) {
        if (all + 1 == std::uint32_t{1} << nodes_[inner.node].children.size())
          insides.push_back(inner.is_negative ? -inside : inside);
      }
      for (const Value inside : insides) {
        const Factoring one{mask, product({factor}, inside)};
        if (std::ranges::find(found, one) == found.end()) found.push_back(one);
      }
    }
  }
  return found;
}

std::size_t comparison_index(Recording& recording, Value lhs, Value rhs, bool nonstrict) {
  auto& sides = recording.sides;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] == std::pair(lhs, rhs) && has_bit(recording.nonstrict, i) == nonstrict) return i;
  }
  if (sides.size() == most_comparisons) throw HarnessFault("a method of too many comparisons to try its ways");
  recording.nonstrict |= bit_if<ComparisonBits>(nonstrict, sides.size());
  sides.emplace_back(lhs, rhs);
  return sides.size() - 1;
}

Recorder recorder_of(const Kernel& kernel) {
  for (const auto room : {sphere_triangle_recorder, moving_sphere_recorder, capsule_triangle_recorder, box_recorder}) {
    if (const Recorder found = room(kernel)) return found;
  }
  return {};
}

}  // namespace axiscert::permitted
