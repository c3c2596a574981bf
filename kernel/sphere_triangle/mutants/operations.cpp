#include "kernel/sphere_triangle/mutants/operations.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "kernel/sphere_triangle/reference/formulae_types.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::mutants {
namespace {

struct Recording {
  std::map<Key, Operation> operations;
  std::vector<std::array<Key, 3>> vectors;
  EnumArray<Comparison, std::pair<Key, Key>> sides{};
};
thread_local Recording* recording = nullptr;

Key record(Operator op, Key left, Key right) {
  const Key key = key_of(op, left, right);
  const auto [known, is_new] = recording->operations.try_emplace(key, Operation{op, left, right, key, ""});
  const Operation& there = known->second;
  if (!is_new && (there.op != op || there.left != left || there.right != right)) {
    throw std::logic_error("two operations have one key");
  }
  return key;
}

// A number that records the operations on it.
template <class Self>
struct Recorded {
  Key key;
  friend Self operator+(const Self& a, const Self& b) { return {{record(Operator::plus, a.key, b.key)}}; }
  friend Self operator-(const Self& a, const Self& b) { return {{record(Operator::minus, a.key, b.key)}}; }
  friend Self operator*(const Self& a, const Self& b) { return {{record(Operator::times, a.key, b.key)}}; }
};
struct Scalar : Recorded<Scalar> {};

// The same, which also records vectors, at the products that take them whole.
struct Component : Recorded<Component> {
  static Component dot(const Vec3<Component>& u, const Vec3<Component>& v) {
    return {{portable::dot(noted(u), noted(v)).key}};
  }
  static Vec3<Component> cross(const Vec3<Component>& u, const Vec3<Component>& v) {
    const Vec3<Scalar> product = portable::cross(noted(u), noted(v));
    return {{{product.x.key}}, {{product.y.key}}, {{product.z.key}}};
  }

 private:
  static Vec3<Scalar> noted(const Vec3<Component>& u) {
    const std::array<Key, 3> vector = {u.x.key, u.y.key, u.z.key};
    auto& all = recording->vectors;
    if (std::find(all.begin(), all.end(), vector) == all.end()) all.push_back(vector);
    return {{{vector[0]}}, {{vector[1]}}, {{vector[2]}}};
  }
};

class Numbering {
 public:
  explicit Numbering(const Recording& recorded) : recorded_(recorded) {
    for (const auto& [lhs, rhs] : recorded.sides) {
      visit(lhs);
      visit(rhs);
    }
  }
  std::vector<Operation> take() { return std::move(all_); }

 private:
  void visit(Key key) {
    const auto found = recorded_.operations.find(key);
    if (found == recorded_.operations.end() || names_.contains(key)) return;
    Operation operation = found->second;
    visit(operation.left);
    visit(operation.right);
    const char* sign = operation.op == Operator::plus ? " + " : operation.op == Operator::minus ? " - " : " * ";
    operation.text = operand(operation.left) + sign + operand(operation.right);
    names_[key] = name_of(operation);
    all_.push_back(std::move(operation));
  }

  static bool is_input(Key key) { return key <= input_key(coordinate_count); }
  std::string operand(Key key) const {
    if (!is_input(key)) return names_.at(key);
    if (key == input_key(coordinate_count)) return "0";
    return coordinate_names[key - input_key(0)];
  }
  // A vertex relative to the centre is "A.x"; a difference of two of them is short enough to be written out.
  std::string name_of(const Operation& operation) const {
    const auto is_vertex = [&](Key key) { return names_.contains(key) && names_.at(key)[1] == '.'; };
    if (operation.op == Operator::minus && is_input(operation.left) && is_input(operation.right)) {
      const std::string vertex = operand(operation.left);  // "ax"
      return {static_cast<char>(vertex[0] - 'a' + 'A'), '.', vertex[1]};
    }
    if (operation.op == Operator::minus && is_vertex(operation.left) && is_vertex(operation.right)) {
      return "(" + operation.text + ")";
    }
    return "#" + std::to_string(all_.size());
  }

  const Recording& recorded_;
  std::map<Key, std::string> names_;
  std::vector<Operation> all_;
};

template <class F>
Operations record_operations() {
  Recording recorded;
  recording = &recorded;
  std::array<Component, coordinate_count + 1> in{};
  for (std::size_t k = 0; k < in.size(); ++k) in[k].key = input_key(k);
  const portable::Problem<Component> problem{
      {in[0], in[1], in[2]}, {in[3], in[4], in[5]}, {in[6], in[7], in[8]}, {in[9], in[10], in[11]}, in[12], in[13]};
  const auto centred = portable::centred(problem);
  for (const auto& [x, y, z] : {centred.a, centred.b, centred.c}) recorded.vectors.push_back({x.key, y.key, z.key});
  F::comparisons(problem, [&](Comparison which, const Component& lhs, const Component& rhs) {
    recorded.sides[which] = {lhs.key, rhs.key};
  });
  recording = nullptr;
  const auto right_side = [&](Comparison which) -> const Operation& {
    return recorded.operations.at(recorded.sides[which].second);
  };
  const Operation& plane = right_side(Comparison::plane_radius);   // rr * e
  const Operation& edge = right_side(Comparison::edge_ab_radius);  // rr * e1, or (rr * e1) * e1
  return {Numbering(recorded).take(), recorded.vectors, plane.right, plane.left, edge.right};
}

}  // namespace

const Operation* Operations::find(Key key) const {
  const auto found = std::find_if(all.begin(), all.end(), [key](const Operation& o) { return o.key == key; });
  return found == all.end() ? nullptr : &*found;
}

const Operations& published_operations() {
  static const Operations operations = record_operations<FormulaeType<Formulae::published>>();
  return operations;
}
const Operations& reduced_operations() {
  static const Operations operations = record_operations<FormulaeType<Formulae::reduced>>();
  return operations;
}

}  // namespace axiscert::mutants
