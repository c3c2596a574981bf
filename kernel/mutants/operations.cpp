#include "kernel/mutants/operations.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "kernel/mutants/forms.h"

namespace axiscert::mutants {
namespace {

struct Recording {
  std::map<Key, Operation> operations;
  std::vector<std::array<Key, 3>> vectors;
  std::vector<std::pair<Key, Key>> sides;  // by comparison
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
struct RecordedOperation {
  Key key = 0;
  RecordedOperation() = default;
  explicit RecordedOperation(Key of) : key(of) {}
  friend Self operator+(const Self& a, const Self& b) { return Self(record(Operator::plus, a.key, b.key)); }
  friend Self operator-(const Self& a, const Self& b) { return Self(record(Operator::minus, a.key, b.key)); }
  friend Self operator*(const Self& a, const Self& b) { return Self(record(Operator::times, a.key, b.key)); }
};
struct Scalar : RecordedOperation<Scalar> {
  using RecordedOperation::RecordedOperation;
};

// The same, which also records vectors, at the products that take them whole.
struct Component : RecordedOperation<Component> {
  using RecordedOperation::RecordedOperation;
  Component() = default;
  explicit Component(double) : RecordedOperation(zero_key) {}  // the formulae's own zero

  static Component dot(const Vec3<Component>& u, const Vec3<Component>& v) {
    return Component(portable::dot(noted(u), noted(v)).key);
  }
  static Vec3<Component> cross(const Vec3<Component>& u, const Vec3<Component>& v) {
    const Vec3<Scalar> product = portable::cross(noted(u), noted(v));
    return {Component(product.x.key), Component(product.y.key), Component(product.z.key)};
  }

 private:
  static Vec3<Scalar> noted(const Vec3<Component>& u) {
    const std::array<Key, 3> vector = {u.x.key, u.y.key, u.z.key};
    auto& all = recording->vectors;
    if (std::find(all.begin(), all.end(), vector) == all.end()) all.push_back(vector);
    return {Scalar(vector[0]), Scalar(vector[1]), Scalar(vector[2])};
  }
};

class Numbering {
 public:
  Numbering(const Predicate& predicate, const Recording& recorded)
      : columns_(predicate.entries.front().columns), recorded_(recorded) {
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

  static bool is_input(Key key) { return key <= zero_key; }
  std::string operand(Key key) const {
    if (!is_input(key)) return names_.at(key);
    if (key == zero_key) return "0";
    return std::string(columns_[key - input_key(0)].name);
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

  const std::vector<PredicateColumn>& columns_;
  const Recording& recorded_;
  std::map<Key, std::string> names_;
  std::vector<Operation> all_;
};

template <class Form>
Operations record_operations() {
  Recording recorded;
  recorded.sides.resize(Form::predicate().comparisons.size());
  recording = &recorded;
  std::array<Component, Form::columns> in;
  for (std::size_t k = 0; k < in.size(); ++k) in[k] = Component(input_key(k));
  for (std::size_t v = 0; v < 3; ++v) {
    auto& vertex = recorded.vectors.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) vertex[axis] = (in[3 * v + axis] - in[9 + axis]).key;
  }
  Form::comparisons(in, Component(zero_key), [&](std::size_t which, const Component& lhs, const Component& rhs) {
    recorded.sides[which] = {lhs.key, rhs.key};
  });
  recording = nullptr;
  const auto right_side = [&](std::size_t which) -> const Operation& {
    return recorded.operations.at(recorded.sides[which].second);
  };
  const Operation& plane = right_side(Form::plane_radius);  // rr * e
  const Operation& edge = right_side(Form::edge_radius);    // rr * e1, or (rr * e1) * e1
  return {Numbering(Form::predicate(), recorded).take(), recorded.vectors, plane.right, plane.left, edge.right};
}

}  // namespace

const Operation* Operations::find(Key key) const {
  const auto found = std::find_if(all.begin(), all.end(), [key](const Operation& o) { return o.key == key; });
  return found == all.end() ? nullptr : &*found;
}

const Operations& operations_of(std::size_t base) {
  return with_form(base, [](auto form) -> const Operations& {
    static const Operations operations = record_operations<decltype(form)>();
    return operations;
  });
}

}  // namespace axiscert::mutants
