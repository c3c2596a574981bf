// Records each step over the lanes of highway-inl.h. No include guard: included once for each HWY_NAMESPACE, after the
// steps.
namespace axiscert::certified::HWY_NAMESPACE {
namespace graph = axiscert::proofs::certified;
using graph::Index, graph::Op;

// A step while it is recorded: its inputs, then what it computes, then its results.
class Recording {
 public:
  Recording(std::string name, int bits, std::vector<bool> answers = {})
      : step_{std::move(name), bits, HWY_NATIVE_FMA != 0, {}, {}} {
    step_.answers = std::move(answers);
    graph::recorder = &step_.graph;
    graph::asked = &step_.asked;
    graph::answers = &step_.answers;
    for (const std::string_view input : graph::query_inputs) step_.graph.input(std::string(input));
  }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  ~Recording() {
    graph::recorder = nullptr;
    graph::asked = nullptr;
    graph::answers = nullptr;
  }

  template <class D, bool fused = true>
  static Problem<Lanes<D, fused>> query() {
    using T = Lanes<D, fused>;
    const auto at = [](Index i) { return T{hn::everywhere<hn::Vec<D>>(i)}; };
    return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, {at(6), at(7), at(8)}, {at(9), at(10), at(11)}, at(12),
            T{hn::Zero(D())}};
  }
  const std::vector<graph::AskedOfLanes>& asked() const { return step_.asked; }
  Index node(Op op, Index a, Index b) { return step_.graph.node(op, {a, b}); }

  // Whether `run` says yes, as a flag, made of what it asks of all lanes and says after each answer.
  template <class Run>
  Index decided(const Run& run, std::vector<bool> given = {}) {
    step_.answers = given;
    step_.asked.clear();
    const bool says = run();
    if (step_.asked.size() == given.size()) return step_.graph.flag(says);
    const graph::AskedOfLanes question = step_.asked[given.size()];
    Index joined = question.flags.front();
    for (const Index flag : question.flags) {
      if (flag != joined) joined = node(question.of_all ? Op::both : Op::either, joined, flag);
    }
    // The answer where `joined` holds, which is no where the question was whether none does.
    const auto after = [&](bool holds) {
      std::vector<bool> more = given;
      more.push_back(holds == question.of_all);
      return decided(run, std::move(more));
    };
    const Index yes = node(Op::both, joined, after(true));
    const Index no = node(Op::both, node(Op::opposite, joined, 0), after(false));
    step_.asked.clear();
    step_.answers.clear();
    return node(Op::either, yes, no);
  }

  template <class Lane>
  void result(std::string name, const hn::Symbols<Lane, 1>& value) {
    result(std::move(name), value.at[0]);
  }
  template <class Lane>
  void result(std::string name, const hn::Flags<Lane, 1>& value) {
    result(std::move(name), value.at[0]);
  }
  void result(std::string name, Index node) { step_.results.push_back({std::move(name), node}); }
  graph::RecordedStep done() { return std::move(step_); }

 private:
  graph::RecordedStep step_;
};

// What `record` records when it is given these answers, and with every other answer to what it asks then.
template <class Record>
graph::RecordedStep with_all_answers(const Record& record, std::vector<bool> answers = {}) {
  graph::RecordedStep step = record(answers);
  for (std::size_t given = answers.size(); given < step.asked.size(); answers.push_back(false), ++given) {
    answers.push_back(true);
    step.otherwise.push_back(with_all_answers(record, answers));
    answers.pop_back();
  }
  return step;
}

template <class Real>
inline constexpr int bits_of_real = sizeof(Real) * 8;
inline constexpr std::array vertex_names = {"a", "b", "c"};
inline constexpr std::array edge_names = {"ab", "bc", "ca"};
inline constexpr std::array opposite_names = {"c", "a", "b"};
inline std::string vertex_side(int from, int to) {
  return std::string("vertex_") + vertex_names[from] + "_side_" + vertex_names[to];
}

// The margins in the order of the comparisons, the thresholds, the answer.
template <class Real>
graph::RecordedStep record_coarse() {
  using D = hn::Tag<Real, 1>;
  Recording recording("coarse", bits_of_real<Real>);
  const auto m = coarse_margins(Recording::query<D>());
  const CoarseLimits<D, true> limits(m.S, m.E);
  const DecidedLanes<D> decided = coarse_step(m, limits);
  recording.result("plane_radius", m.plane.v);
  for (int i = 0; i < 3; ++i) {
    const std::string vertex = std::string("vertex_") + vertex_names[i];
    const int next = (i + 1) % 3, last = (i + 2) % 3;
    const auto side = [&](const Lanes<D>& margin, int to) { recording.result(vertex_side(i, to), margin.v); };
    recording.result(vertex + "_radius", m.vertex[i].radius.v);
    if (next < last) side(m.vertex[i].away, next), side(m.vertex[i].towards, last);
    else side(m.vertex[i].towards, last), side(m.vertex[i].away, next);
  }
  for (int i = 0; i < 3; ++i) {
    const std::string edge = std::string("edge_") + edge_names[i];
    recording.result(edge + "_radius", m.edge[i].radius.v);
    recording.result(edge + "_side_" + opposite_names[i], m.edge[i].side.v);
  }
  recording.result("S", m.S.v);
  recording.result("E", m.E.v);
  recording.result("degree_2", limits.degree2.v);
  recording.result("degree_4", limits.degree4.v);
  recording.result("degree_6", limits.degree6.v);
  recording.result("separated", decided.separated);
  recording.result("contact", decided.contact);
  if constexpr (sizeof(Real) == 8) recording.result("in_deep_range", limits.in_deep_range(m.S, m.r));
  recording.result("known", coarsely_known(D(), m, limits));
  return recording.done();
}

// A number that is no lane, as SphereBox computes with.
struct Symbol {
  Index node;
  Symbol() = default;
  Symbol(double x) : node(graph::recorder->number(x)) {}  // NOLINT: numbers become symbols
  Symbol(Op op, Index a, Index b) : node(graph::recorder->node(op, {a, b})) {}
  friend Symbol operator+(Symbol a, Symbol b) { return {Op::add, a.node, b.node}; }
  friend Symbol operator-(Symbol a, Symbol b) { return {Op::subtract, a.node, b.node}; }
  friend Symbol operator-(Symbol a) { return {Op::negate, a.node, 0}; }
};
struct SymbolFlag {
  Index node;
  friend SymbolFlag operator&(SymbolFlag a, SymbolFlag b) {
    return {graph::recorder->node(Op::both, {a.node, b.node})};
  }
};
inline SymbolFlag operator>=(Symbol a, Symbol b) { return {graph::recorder->node(Op::at_most, {b.node, a.node})}; }
inline SymbolFlag operator==(Symbol a, Symbol b) { return {graph::recorder->node(Op::equal, {a.node, b.node})}; }
inline Symbol chosen(SymbolFlag flag, Symbol yes, Symbol no) {
  Symbol made;
  made.node = graph::recorder->node(Op::choose, {flag.node, yes.node, no.node});
  return made;
}

// The box's ends; whether a triangle is beyond it, as columns and as vertices that are vectors; the outcode of vertex
// A.
template <class Real>
graph::RecordedStep record_box() {
  using D = hn::Tag<Real, 1>;
  using D4 = hn::Tag<Real, 4>;
  Recording recording("box", bits_of_real<Real>);
  const auto input = [](Index i) {
    Symbol made;
    made.node = i;
    return made;
  };
  const SphereBox<Symbol> ends(input(9), input(10), input(11), input(12));
  SphereBox<Real> box(0, 0, 0, 0);
  constexpr const char* axes[] = {"_x", "_y", "_z"};
  for (int k = 0; k < 3; ++k) {
    box.low[k] = graph::as_number<Real>(ends.low[k].node);
    box.high[k] = graph::as_number<Real>(ends.high[k].node);
    recording.result(std::string("low") + axes[k], ends.low[k].node);
    recording.result(std::string("high") + axes[k], ends.high[k].node);
  }
  recording.result("beyond", recording.decided([&] {
    const bool says = BoxStep<D>(box).all_beyond(Recording::query<D>());
    for (const auto& question : recording.asked()) {
      if (!question.of_all)
        throw std::logic_error("the box passes a vector over where not all of its lanes are beyond");
    }
    return says;
  }));
  // The fourth lane is whatever follows in memory.
  const auto vertex = [](Index x, Index y, Index z) { return hn::Vec<D4>{{x, y, z, 12}}; };
  const auto end = [](const Symbol(&of)[3]) { return hn::Vec<D4>{{of[0].node, of[1].node, of[2].node, 12}}; };
  recording.result("vertices_beyond", recording.decided([&] {
    return is_beyond(D4(), vertex(0, 1, 2), vertex(3, 4, 5), vertex(6, 7, 8), end(ends.low), end(ends.high));
  }));
  recording.result("outcode", outcodes_of(D(), box, hn::Vec<D>{{0}}, hn::Vec<D>{{1}}, hn::Vec<D>{{2}}));
  return recording.done();
}

// The answer of all lanes; the fourth is the first again.
template <class Real>
graph::RecordedStep record_pair() {
  using D = hn::Tag<Real, 4>;
  Real numbers[13];
  for (Index i = 0; i < 13; ++i) numbers[i] = graph::as_number<Real>(i);
  // Each verdict is what is asked of all lanes, or its opposite, whatever the answer to the other question is.
  std::array<bool, 2> is_opposite{};
  for (unsigned answers = 0; answers < 4; ++answers) {
    const std::array<bool, 2> given = {(answers & 1u) != 0, (answers & 2u) != 0};
    Recording recording("pair", bits_of_real<Real>, {given[0], given[1]});
    const PairStep<D> step(numbers, numbers + 9);
    const std::array<bool, 2> found = {step.separated(), step.contact()};
    for (std::size_t k = 0; k < 2; ++k) {
      if (answers == 0) is_opposite[k] = found[k];
      if (found[k] != (given[k] != is_opposite[k])) throw std::logic_error("a pair's verdict is not what it asked");
    }
  }
  Recording recording("pair", bits_of_real<Real>);
  const PairStep<D> step(numbers, numbers + 9);
  const auto verdict = [&](std::size_t k) {
    const auto& [of_all, lanes] = recording.asked().at(k);
    if (lanes.size() != 4 || lanes[3] != lanes[0]) throw std::logic_error("the fourth lane is not the first");
    const Op op = of_all ? Op::both : Op::either;
    const Index joined = recording.node(op, recording.node(op, lanes[0], lanes[1]), lanes[2]);
    // That none holds is the opposite of that some does.
    return of_all != is_opposite[k] ? joined : recording.node(Op::opposite, joined, 0);
  };
  recording.result("separated", verdict(0));
  recording.result("contact", verdict(1));
  return recording.done();
}

// Each margin with its bound, in the order of the comparisons; the answers for the closed and the open sphere.
inline graph::RecordedStep record_fine(const std::vector<bool>& answers) {
  using D = hn::Tag<double, 1>;
  Recording recording("fine", 64, answers);
  const FineStep<D> step(D(), Recording::query<D>(), false);
  const auto add = [&](const std::string& name, const auto& margin) {
    recording.result(name, margin.value);
    recording.result(name + "_bound", margin.bound);
  };
  const auto normal = step.normal();
  add("plane_radius", step.plane_radius(normal, step.offset(normal)));
  add("vertex_a_radius", step.vertex_radius(step.a));
  add("vertex_a_side_b", step.vertex_side(step.a, step.ab));
  add("vertex_a_side_c", step.opposite_vertex_side(step.a, step.ca));
  add("vertex_b_radius", step.vertex_radius(step.b));
  add("vertex_b_side_a", step.opposite_vertex_side(step.b, step.ab));
  add("vertex_b_side_c", step.vertex_side(step.b, step.bc));
  add("vertex_c_radius", step.vertex_radius(step.c));
  add("vertex_c_side_a", step.vertex_side(step.c, step.ca));
  add("vertex_c_side_b", step.opposite_vertex_side(step.c, step.bc));
  const auto edge = [&](const std::string& name, const char* opposite, const auto& from, const auto& along) {
    const auto N = step.normal_of(from, along);
    add(name + "_radius", step.edge_radius(N, along));
    add(name + "_side_" + opposite, step.edge_side(N, normal));
  };
  edge("edge_ab", "c", step.a, step.ab);
  edge("edge_bc", "a", step.b, step.bc);
  edge("edge_ca", "b", step.c, step.ca);
  recording.result("valid", step.is_valid());
  recording.result("sound", step.is_sound());
  for (const bool open : {false, true}) {
    const std::string sphere = open ? "_open" : "_closed";
    const auto found = FineStep<D>(D(), Recording::query<D>(), open).answer();
    recording.result("separated" + sphere, found.decided.separated);
    recording.result("contact" + sphere, found.decided.contact);
    recording.result("known" + sphere, found.known);
  }
  return recording.done();
}

template <DeepComparison what>
graph::RecordedStep record_deep(const std::string& name, const std::vector<bool>& answers) {
  using D = hn::Tag<double, 1>;
  Recording recording("deep_" + name, 64, answers);
  for (const bool open : {false, true}) {
    const std::string sphere = open ? "_open" : "_closed";
    const auto found = DeepStep<D>(D(), Recording::query<D>(), open).template answer<what>();
    recording.result("holds" + sphere, found.holds);
    recording.result("fails" + sphere, found.fails);
  }
  return recording.done();
}

template <class Real>
graph::RecordedStep record_conservative(bool scaled) {
  using D = hn::Tag<Real, 1>;
  Recording recording(scaled ? "conservative_scaled" : "conservative", bits_of_real<Real>);
  const auto q = Recording::query<D, false>();
  const auto found = scaled ? Conservative<D>::answer_scaled(q) : Conservative<D>::answer(q);
  recording.result("separated", found.separated);
  recording.result("unknown", found.unknown);
  return recording.done();
}

inline graph::RecordedStep record_scaling(const std::vector<bool>& answers) {
  using D = hn::Tag<double, 1>;
  Recording recording("scaling", 64, answers);
  const ScaledToRange<D> scaled(D(), Recording::query<D>());
  for (std::size_t k = 0; k < 13; ++k) {
    recording.result("scaled_" + std::string(graph::query_inputs[k]), scaled.number[k]);
  }
  recording.result("useful", scaled.useful);
  return recording.done();
}

inline void record(std::vector<graph::RecordedStep>& all) {
  all.push_back(record_coarse<float>());
  all.push_back(record_coarse<double>());
  all.push_back(record_pair<float>());
  all.push_back(record_pair<double>());
  all.push_back(with_all_answers(record_fine));
  const auto deep = [&]<DeepComparison what>(const std::string& name) {
    all.push_back(with_all_answers([&](const std::vector<bool>& answers) { return record_deep<what>(name, answers); }));
  };
  deep.operator()<DeepComparison::vertex_radius>("vertex_radius");
  deep.operator()<DeepComparison::vertex_sides>("vertex_sides");
  deep.operator()<DeepComparison::edge_radius>("edge_radius");
  deep.operator()<DeepComparison::edge_side>("edge_side");
  deep.operator()<DeepComparison::plane_radius>("plane_radius");
  if (HWY_NATIVE_FMA) return;  // the conservative test is never fused
  for (const bool scaled : {false, true}) {
    all.push_back(record_conservative<float>(scaled));
    all.push_back(record_conservative<double>(scaled));
  }
}

}  // namespace axiscert::certified::HWY_NAMESPACE
