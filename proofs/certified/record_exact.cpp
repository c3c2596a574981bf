// The exact step's margins (kernel/sphere_triangle/certified/numbers/exact_margins.h) over integers that are symbols.
#include <stdexcept>

#include "proofs/certified/graph.h"
#include "kernel/sphere_triangle/certified/numbers/exact_margins.h"

namespace axiscert::proofs::certified {
namespace {

// The degree of each node, by which the exact step chooses its number of words.
thread_local std::vector<int>* degrees = nullptr;

template <int degree>
struct Whole {
  Index node = 0;

  static Whole of(Op op, Index a, Index b) {
    const Whole made{recorder->node(op, {a, b})};
    degrees->resize(recorder->nodes().size(), 0);
    int& known = degrees->at(made.node);
    if (known != 0 && known != degree) throw std::logic_error("record_exact: one value of two degrees");
    known = degree;
    return made;
  }
  friend Whole operator+(const Whole& a, const Whole& b) { return of(Op::add, a.node, b.node); }
  friend Whole operator-(const Whole& a, const Whole& b) { return of(Op::subtract, a.node, b.node); }
};
template <class Result, int m, int n>
Result product(const Whole<m>& a, const Whole<n>& b) {
  return Result::of(Op::multiply, a.node, b.node);
}
struct Wholes {
  template <int degree>
  using Value = Whole<degree>;
};

}  // namespace

RecordedExact recorded_exact() {
  RecordedExact exact;
  recorder = &exact.graph;
  degrees = &exact.degree;
  Whole<1> q[13];
  for (Index i = 0; i < 13; ++i) {
    q[i].node = exact.graph.input(std::string(query_inputs[i]));
    exact.degree.push_back(1);
  }
  const axiscert::certified::ExactMargins<Wholes> m(q);
  const auto add = [&](std::string name, const auto& value) { exact.results.push_back({std::move(name), value.node}); };
  const auto add_vector = [&](const std::string& name, const auto& v) {
    add(name + "_x", v.x);
    add(name + "_y", v.y);
    add(name + "_z", v.z);
  };
  // In the order of the comparisons, then what has to differ from zero for an axis to have a normal.
  constexpr const char* vertices[] = {"a", "b", "c"};
  const auto V = m.plane_normal();
  add("plane_radius", m.plane_radius(V));
  for (int i = 0; i < 3; ++i) {
    const std::string name = std::string("vertex_") + vertices[i];
    add(name + "_radius", m.vertex_radius(i));
    for (int to = 0; to < 3; ++to) {
      if (to != i) add(name + "_side_" + vertices[to], m.vertex_side(i, to));
    }
  }
  for (int i = 0; i < 3; ++i) {
    const int next = m.next(i), last = m.last(i);
    const std::string name = std::string("edge_") + vertices[i] + vertices[next];
    const auto along = m.along(i);
    const auto N = m.edge_normal(i, along);
    add(name + "_radius", m.edge_radius(N, along));
    add(name + "_side_" + vertices[last], m.edge_side(N, V));
  }
  add_vector("normal", V);
  for (int i = 0; i < 3; ++i) add_vector(std::string("along_") + vertices[i], m.along(i));
  recorder = nullptr;
  degrees = nullptr;
  return exact;
}

}  // namespace axiscert::proofs::certified
