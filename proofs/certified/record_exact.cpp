// The exact step over integers that are symbols: its margins
// (kernel/sphere_triangle/certified/exact_margins.h), and its verdict of their signs (exact_test.h) as trees of
// questions; and which integers it takes (widths.h).
#include <iterator>
#include <stdexcept>

#include "proofs/certified/graph.h"
#include "kernel/sphere_triangle/certified/exact_test.h"
#include "kernel/sphere_triangle/certified/widths.h"

namespace axiscert::proofs::certified {
namespace {

// The degree of each node, by which the exact step chooses its number of words.
thread_local std::vector<int>* degrees = nullptr;

// The answers given to what a run asks, and what it asked: first those given, then yes.
struct Script {
  std::vector<std::pair<Asked, bool>> answers;
  std::size_t next = 0;

  bool ask(Asked what) {
    if (next == answers.size()) answers.emplace_back(what, true);
    const auto& [asked, answer] = answers[next++];
    if (!(asked == what)) throw std::logic_error("record_exact: another question after the same answers");
    return answer;
  }
};
thread_local Script* script = nullptr;

// The tree of what `run` asks, after these answers.
template <class Run>
AskedTree tree_of(const Run& run, std::vector<std::pair<Asked, bool>> given = {}) {
  Script asks{given};
  script = &asks;
  AskedTree tree{.answer = run()};
  script = nullptr;
  if (asks.answers.size() == given.size()) return tree;
  tree.asked = asks.answers[given.size()].first;
  for (const bool answer : {true, false}) {
    given.emplace_back(*tree.asked, answer);
    tree.after.push_back(tree_of(run, given));
    given.pop_back();
  }
  return tree;
}

template <int degree>
struct Whole {
  Index node = 0;

  bool is_positive() const { return script->ask({Asked::positive, node}); }
  bool is_negative() const { return script->ask({Asked::negative, node}); }
  bool is_zero() const { return script->ask({Asked::zero, node}); }
  bool is_at_least_zero() const { return script->ask({Asked::at_least_zero, node}); }
  bool is_at_most_zero() const { return script->ask({Asked::at_most_zero, node}); }

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

using axiscert::certified::ExactTest, axiscert::certified::KnownResults;

// Asks for each bit of what is known.
struct AskedKnown {
  bool has(int group, int axis) const {
    return script->ask({Asked::known, static_cast<Index>(group / 8), static_cast<Index>(axis)});
  }
};
// Asks which axes separate.
struct AskedAxes {
  static bool separates(int axis) { return script->ask({Asked::separates, static_cast<Index>(axis)}); }
  static int normal() { return 0; }
  static bool vertex_separates(int i) { return separates(KnownResults::vertex_axis + i); }
  static bool plane_separates(int) { return separates(KnownResults::plane_axis); }
  static bool edge_separates(int i, int) { return separates(KnownResults::edge_axis + i); }
};

template <int size>
RecordedSize recorded_size() {
  using Integers = axiscert::certified::Integers<size>;
  const auto words = []<class Value>() { return static_cast<int>(sizeof(Value) / sizeof(std::uint64_t)); };
  return {size,
          axiscert::certified::negligible_radius(size),
          {words.template operator()<typename Integers::template Value<1>>(),
           words.template operator()<typename Integers::template Value<2>>(),
           words.template operator()<typename Integers::template Value<3>>(),
           words.template operator()<typename Integers::template Value<4>>(),
           words.template operator()<typename Integers::template Value<6>>()}};
}
template <std::size_t... i>
std::vector<RecordedSize> recorded_sizes(std::index_sequence<i...>) {
  return {recorded_size<axiscert::certified::integer_sizes[i]>()...};
}

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
  for (const bool open : {false, true}) {
    const ExactTest<Wholes, AskedKnown> test(q, open, {});
    for (int i = 0; i < 3; ++i) exact.axes[open].push_back(tree_of([&] { return test.vertex_separates(i); }));
    exact.axes[open].push_back(tree_of([&] { return test.plane_separates(V); }));
    for (int i = 0; i < 3; ++i) exact.axes[open].push_back(tree_of([&] { return test.edge_separates(i, V); }));
  }
  // Each axis is asked alone.
  constexpr int groups[] = {KnownResults::fails, KnownResults::radius, KnownResults::sides};
  for (int axis = 0; axis < KnownResults::axes; ++axis) {
    const KnownResults others{0b1111111u & ~(std::uint64_t{1} << axis)};
    exact.told.emplace_back();
    for (const int group : groups) {
      exact.told.back().push_back(tree_of([&] { return axiscert::certified::with_signs(m, others).has(group, axis); }));
    }
  }
  exact.verdict = tree_of([] { return axiscert::certified::some_axis_separates(AskedAxes()); });
  // The axes of the plane and the edges that are known to fail, then the edges whose sides are known to hold.
  for (std::uint64_t fails = 0; fails < 16; ++fails) {
    for (std::uint64_t sides = 0; sides < 8; ++sides) {
      exact.needs_normal.push_back(
          axiscert::certified::needs_normal({fails << (KnownResults::fails + KnownResults::plane_axis) |
                                             sides << (KnownResults::sides + KnownResults::edge_axis)}));
    }
  }
  exact.sizes = recorded_sizes(std::make_index_sequence<std::size(axiscert::certified::integer_sizes)>());
  for (int bits = 0; bits < 2200; ++bits) exact.size_for.push_back(axiscert::certified::integer_size_for(bits));
  recorder = nullptr;
  degrees = nullptr;
  return exact;
}

}  // namespace axiscert::proofs::certified
