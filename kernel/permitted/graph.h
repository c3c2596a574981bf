// Formulae as a graph of sums and products, from which the evaluations that a compiler may choose are read: a sum of
// several terms is one node if it may be reassociated.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "kernel/base/geometry.h"
#include "kernel/permitted/permissions.h"

namespace axiscert::permitted {

// A node, or its negative: a change of sign is exact, and no operation.
struct Value {
  std::uint32_t node = 0;
  bool is_negative = false;
  friend Value operator-(Value v) { return {v.node, !v.is_negative}; }
  auto operator<=>(const Value&) const = default;
};

enum class Kind : std::uint8_t { input, constant, sum, product, magnitude, kept };

// Terms `mask` of a sum, as a product of their common factor and the sum of the rest.
struct Factoring {
  std::uint32_t mask;
  Value product;
};

struct Node {
  Kind kind;
  double payload = 0;           // number of the input; value of the constant
  std::vector<Value> children;  // terms, factors, or the operand
  std::vector<Factoring> factorings = {};
};

class Graph {
 public:
  static constexpr std::size_t most_children = 10;  // 3^10 splits of a node

  explicit Graph(const Permissions& permissions) : permissions_(permissions) {}
  const Permissions& permissions() const { return permissions_; }
  // Children come before the nodes that have them.
  const std::vector<Node>& nodes() const { return nodes_; }

  Value input(std::size_t number) { return {made(Kind::input, static_cast<double>(number), {})}; }
  Value constant(double value) { return {made(Kind::constant, value, {})}; }
  Value sum(Value a, Value b);
  Value product(Value a, Value b);
  Value magnitude(Value a) { return {made(Kind::magnitude, 0, {{a.node}})}; }
  // a, behind a barrier where these are kept.
  Value kept(Value a) { return permissions_.kept ? Value{made(Kind::kept, 0, {a})} : a; }

 private:
  bool is_zero(Value v) const { return nodes_[v.node].kind == Kind::constant && nodes_[v.node].payload == 0; }
  std::uint32_t made(Kind kind, double payload, std::vector<Value> children);
  Value sum_of(std::vector<Value> terms);
  Value product_of(std::vector<Value> factors);
  std::vector<Factoring> factorings_of(const std::vector<Value>& terms);

  Permissions permissions_;
  std::vector<Node> nodes_;
  std::map<std::tuple<Kind, double, std::vector<Value>>, std::uint32_t> known_;
};

// The number type that formulae are evaluated over to become a graph, which is the thread's at that time.
struct RecordedNumber {
  Value value;
  static thread_local Graph* graph;

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
  friend RecordedNumber magnitude(const RecordedNumber& a) { return RecordedNumber(graph->magnitude(a.value)); }
  static RecordedNumber translated(const RecordedNumber& x, const RecordedNumber& p) {
    return RecordedNumber(graph->kept(graph->sum(x.value, -p.value)));
  }
};

}  // namespace axiscert::permitted
