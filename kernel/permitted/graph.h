// Formulae as a graph of sums, products and quotients, from which the evaluations that a compiler may choose are read:
// a sum of several terms is one node if it may be reassociated.
#pragma once

#include <cstdint>
#include <functional>
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

}  // namespace axiscert::permitted
