// Formulae as a graph of sums, products and quotients, from which the evaluations that a compiler may choose are read:
// a sum of several terms is one node if it may be reassociated.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "kernel/base/geometry.h"
#include "kernel/formulae_kernel.h"
#include "kernel/permitted/permissions.h"

namespace axiscert::permitted {

// A node, or its negative: a change of sign is exact, and no operation.
struct Value {
  std::uint32_t node = 0;
  bool is_negative = false;
  friend Value operator-(Value v) { return {v.node, !v.is_negative}; }
  auto operator<=>(const Value&) const = default;
};

// A reciprocal is a factor of a product alone: its divisor divides any product of the other factors.
enum class Kind : std::uint8_t {
  input,
  constant,
  sum,
  product,
  quotient,
  reciprocal,
  magnitude,
  least,
  greatest,
  kept
};

// Terms `mask` of a sum, as a product of their common factor and the sum of the rest.
struct Factoring {
  std::uint32_t mask;
  Value product;
  bool operator==(const Factoring&) const = default;
};

struct Node {
  Kind kind;
  double payload = 0;           // number of the input; value of the constant
  std::vector<Value> children;  // terms, factors, dividend and divisor, or the operand
  std::vector<Factoring> factorings = {};
};

class Graph {
 public:
  static constexpr std::size_t most_children = 12;  // 3^12 splits of a node

  explicit Graph(const Permissions& permissions) : permissions_(permissions) {}
  const Permissions& permissions() const { return permissions_; }
  // Children come before the nodes that have them.
  const std::vector<Node>& nodes() const { return nodes_; }

  Value input(std::size_t number) { return {made(Kind::input, static_cast<double>(number), {})}; }
  Value constant(double value) { return {made(Kind::constant, value, {})}; }
  Value sum(Value a, Value b);
  Value product(Value a, Value b);
  Value quotient(Value a, Value b);
  Value magnitude(Value a) { return {made(Kind::magnitude, 0, {{a.node}})}; }
  Value least(Value a, Value b) { return {made(Kind::least, 0, {a, b})}; }
  Value greatest(Value a, Value b) { return {made(Kind::greatest, 0, {a, b})}; }
  // a, behind a barrier where these are kept.
  Value kept(Value a) { return permissions_.kept ? Value{made(Kind::kept, 0, {a})} : a; }

 private:
  bool is(Value v, double constant) const {
    return nodes_[v.node].kind == Kind::constant && nodes_[v.node].payload == constant &&
           !(v.is_negative && constant != 0);
  }
  std::uint32_t made(Kind kind, double payload, std::vector<Value> children);
  Value sum_of(std::vector<Value> terms);
  Value product_of(std::vector<Value> factors);
  std::vector<Factoring> factorings_of(const std::vector<Value>& terms);
  bool is_divisor(Value v) const { return nodes_[v.node].kind == Kind::reciprocal; }

  Permissions permissions_;
  std::vector<Node> nodes_;
  std::map<std::tuple<Kind, double, std::vector<Value>>, std::uint32_t> known_;
};

// The number type that formulae are evaluated over to become a graph, which is the thread's at that time. Where they
// branch, `decide` says which way; it is asked whether lhs > rhs, or lhs >= rhs.
struct RecordedNumber {
  Value value;
  static thread_local Graph* graph;
  static thread_local const std::function<bool(Value lhs, Value rhs, bool nonstrict)>* decide;

  RecordedNumber() = default;
  explicit RecordedNumber(Value v) : value(v) {}
  explicit RecordedNumber(double constant) : value(graph->constant(constant)) {}
  friend RecordedNumber operator+(const RecordedNumber& a, const RecordedNumber& b) {
    return RecordedNumber(graph->sum(a.value, b.value));
  }
  friend RecordedNumber operator-(const RecordedNumber& a, const RecordedNumber& b) {
    return RecordedNumber(graph->sum(a.value, -b.value));
  }
  friend RecordedNumber operator*(const RecordedNumber& a, const RecordedNumber& b) {
    return RecordedNumber(graph->product(a.value, b.value));
  }
  friend RecordedNumber operator/(const RecordedNumber& a, const RecordedNumber& b) {
    return RecordedNumber(graph->kept(graph->quotient(a.value, b.value)));
  }
  friend bool operator>(const RecordedNumber& a, const RecordedNumber& b) { return (*decide)(a.value, b.value, false); }
  friend bool operator>=(const RecordedNumber& a, const RecordedNumber& b) { return (*decide)(a.value, b.value, true); }
  friend RecordedNumber magnitude(const RecordedNumber& a) { return RecordedNumber(graph->magnitude(a.value)); }
  friend RecordedNumber lesser(const RecordedNumber& a, const RecordedNumber& b) {
    return RecordedNumber(graph->least(a.value, b.value));
  }
  friend RecordedNumber greater(const RecordedNumber& a, const RecordedNumber& b) {
    return RecordedNumber(graph->greatest(a.value, b.value));
  }
  static RecordedNumber translated(const RecordedNumber& x, const RecordedNumber& p) {
    return RecordedNumber(graph->kept(graph->sum(x.value, -p.value)));
  }
};

// The formulae that permissions are applied to, as graphs. Each predicate's room records its own.

// A way through formulae that branch: the comparisons that it asks, in order, and what each has to say.
struct Path {
  std::vector<std::pair<std::size_t, bool>> decisions;  // index of the comparison
  ComparisonBits holding = 0, failing = 0;
  bool separates = false;
};

struct Recording {
  Graph graph;
  std::vector<std::pair<Value, Value>> sides = {};  // by comparison; a comparison is lhs > rhs
  ComparisonBits nonstrict = 0;                     // those that are lhs >= rhs
  std::vector<Path> paths = {};  // of formulae that branch: all; else the predicate's clauses make the verdict
};
using Recorder = std::function<Recording(const Permissions&)>;

// The recorder of the formulae that a kernel claims; empty where they are not known here.
Recorder recorder_of(const Kernel& kernel);
Recorder sphere_triangle_recorder(const Kernel& kernel);
Recorder moving_sphere_recorder(const Kernel& kernel);
Recorder capsule_triangle_recorder(const Kernel& kernel);
Recorder box_recorder(const Kernel& kernel);

// The index of a comparison, which is made where it is new.
std::size_t comparison_index(Recording& recording, Value lhs, Value rhs, bool nonstrict);

// Runs `evaluate(load, sink)` over numbers that record.
template <class Evaluate>
Recording recorded(const Permissions& permissions, std::size_t comparisons, ComparisonBits nonstrict,
                   Evaluate&& evaluate) {
  Recording made{Graph(permissions), std::vector<std::pair<Value, Value>>(comparisons), nonstrict};
  RecordedNumber::graph = &made.graph;
  evaluate([&](std::size_t k) { return RecordedNumber(made.graph.input(k)); },
           [&](std::size_t i, const RecordedNumber& lhs, const RecordedNumber& rhs) {
             made.sides[i] = {lhs.value, rhs.value};
           });
  RecordedNumber::graph = nullptr;
  return made;
}

// Records a method that says whether they are separate: every way that its comparisons may go.
// `separated(load)` is called once for each.
template <class Separated>
Recording recorded_paths(const Permissions& permissions, Separated&& separated) {
  Recording made{Graph(permissions)};
  RecordedNumber::graph = &made.graph;
  Path path;
  std::vector<bool> script;  // what the next comparisons are told
  const std::function<bool(Value, Value, bool)> decide = [&](Value lhs, Value rhs, bool nonstrict) {
    const std::size_t i = comparison_index(made, lhs, rhs, nonstrict);
    const std::size_t step = path.decisions.size();
    const bool holds = step < script.size() && script[step];
    path.decisions.emplace_back(i, holds);
    (holds ? path.holding : path.failing) |= one_bit<ComparisonBits>(i);
    return holds;
  };
  RecordedNumber::decide = &decide;
  do {
    path = {};
    path.separates = separated([&](std::size_t k) { return RecordedNumber(made.graph.input(k)); });
    // The next way differs in the last decision that said no.
    script.clear();
    for (const auto& [i, holds] : path.decisions) script.push_back(holds);
    while (!script.empty() && script.back()) script.pop_back();
    if (!script.empty()) script.back() = true;
    made.paths.push_back(std::move(path));
  } while (!script.empty());
  RecordedNumber::decide = nullptr;
  RecordedNumber::graph = nullptr;
  return made;
}

// Records formulae as kernel/formulae_kernel.h has them: `found` where the kernel claims them.
template <class Test, class F>
void put_recorder(const Kernel& kernel, Recorder& found) {
  using T = RecordedNumber;
  if (kernel.predicate != &Test::description() || kernel.entry != entry_of<Test>() || kernel.formulae != F::name)
    return;
  found = [](const Permissions& permissions) {
    return recorded(
        permissions, Test::description().comparisons.size(), nonstrict_comparisons<F>(),
        [](auto&& load, auto&& sink) { F::template comparisons<T>(Test::template problem<T>(load), sink); });
  };
}

}  // namespace axiscert::permitted
