// Records each step over the lanes of highway-inl.h. No include guard: included once for each HWY_NAMESPACE, after the
// steps.
namespace axiscert::certified::HWY_NAMESPACE {
namespace graph = axiscert::proofs::certified;
using graph::Index, graph::Op;

// A step while it is recorded: its inputs, then what it computes, then its results.
class Recording {
 public:
  Recording(std::string name, int bits) : step_{std::move(name), bits, HWY_NATIVE_FMA != 0, {}, {}} {
    graph::recorder = &step_.graph;
    graph::asked = &asked_;
    for (const std::string_view input : graph::query_inputs) step_.graph.input(std::string(input));
  }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  ~Recording() {
    graph::recorder = nullptr;
    graph::asked = nullptr;
  }

  template <class D, bool fused = true>
  static Problem<Lanes<D, fused>> query() {
    using T = Lanes<D, fused>;
    const auto at = [](Index i) { return T{hn::everywhere<hn::Vec<D>>(i)}; };
    return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, {at(6), at(7), at(8)}, {at(9), at(10), at(11)}, at(12),
            T{hn::Zero(D())}};
  }
  // The flags of the k-th question about all lanes.
  const std::vector<Index>& asked(std::size_t k) const { return asked_.at(k); }
  Index node(Op op, Index a, Index b) { return step_.graph.node(op, {a, b}); }

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
  std::vector<std::vector<Index>> asked_;
};

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

// The answer of all lanes; the fourth is the first again.
template <class Real>
graph::RecordedStep record_pair() {
  using D = hn::Tag<Real, 4>;
  Recording recording("pair", bits_of_real<Real>);
  Real numbers[13];
  for (Index i = 0; i < 13; ++i) numbers[i] = graph::as_number<Real>(i);
  const PairStep<D> step(numbers, numbers + 9);
  const auto joined = [&](std::size_t question, Op op) {
    const std::vector<Index>& lanes = recording.asked(question);
    if (lanes.size() != 4 || lanes[3] != lanes[0]) throw std::logic_error("the fourth lane is not the first");
    return recording.node(op, recording.node(op, lanes[0], lanes[1]), lanes[2]);
  };
  recording.result("separated", joined(0, Op::either));
  recording.result("contact", joined(1, Op::both));
  return recording.done();
}

// Each margin with its bound, in the order of the comparisons; the answers for the closed and the open sphere.
inline graph::RecordedStep record_fine() {
  using D = hn::Tag<double, 1>;
  Recording recording("fine", 64);
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
graph::RecordedStep record_deep(const std::string& name) {
  using D = hn::Tag<double, 1>;
  Recording recording("deep_" + name, 64);
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

inline void record(std::vector<graph::RecordedStep>& all) {
  all.push_back(record_coarse<float>());
  all.push_back(record_coarse<double>());
  all.push_back(record_pair<float>());
  all.push_back(record_pair<double>());
  all.push_back(record_fine());
  all.push_back(record_deep<DeepComparison::vertex_radius>("vertex_radius"));
  all.push_back(record_deep<DeepComparison::vertex_sides>("vertex_sides"));
  all.push_back(record_deep<DeepComparison::edge_radius>("edge_radius"));
  all.push_back(record_deep<DeepComparison::edge_side>("edge_side"));
  all.push_back(record_deep<DeepComparison::plane_radius>("plane_radius"));
  if (HWY_NATIVE_FMA) return;  // the conservative test is never fused
  for (const bool scaled : {false, true}) {
    all.push_back(record_conservative<float>(scaled));
    all.push_back(record_conservative<double>(scaled));
  }
}

}  // namespace axiscert::certified::HWY_NAMESPACE
