// In place of the steps that blocks of queries are taken through: each asks a script instead, by the numbers in its
// lanes, and notes which query each lane has. No include guard: included once, in recorded_blocks.cpp.
namespace axiscert::certified {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace graph = axiscert::proofs::certified;
using axiscert::HWY_NAMESPACE::Problem, axiscert::HWY_NAMESPACE::Vec3;
using graph::LaneQuery, graph::Script, graph::script;

template <class D, bool fused = true>
struct Lanes {
  hn::Vec<D> v;
};
template <class D>
struct DecidedLanes {
  hn::Mask<D> separated, contact;
};

template <class D>
inline constexpr std::size_t lanes_in = hn::MaxLanes(D());
template <class D>
using LaneQueries = std::array<LaneQuery, lanes_in<D>>;

template <class D, bool fused>
LaneQueries<D> lanes_of(const Problem<Lanes<D, fused>>& q) {
  const D d;
  hn::TFromD<D> number[13][lanes_in<D>];
  const Lanes<D, fused>* const from[13] = {&q.a.x, &q.a.y, &q.a.z, &q.b.x, &q.b.y, &q.b.z, &q.c.x,
                                           &q.c.y, &q.c.z, &q.p.x, &q.p.y, &q.p.z, &q.r};
  for (int k = 0; k < 13; ++k) hn::StoreU(from[k]->v, d, number[k]);
  LaneQueries<D> lanes;
  for (std::size_t j = 0; j < lanes.size(); ++j) {
    double numbers[13];
    for (int k = 0; k < 13; ++k) numbers[k] = static_cast<double>(number[k][j]);
    lanes[j] = script->query_of(numbers);
  }
  return lanes;
}
// A mask, and words, lane by lane; says(query) is what the script says of it. Of padding everything is said.
template <class D, class Says>
hn::Mask<D> mask_of(const LaneQueries<D>& lanes, const Says& says) {
  hn::TFromD<D> x[lanes_in<D>];
  for (std::size_t j = 0; j < lanes.size(); ++j) x[j] = lanes[j].is_padding() || says(lanes[j]) ? 1 : 0;
  return hn::Eq(hn::LoadU(D(), x), hn::Set(D(), 1));
}
template <class D, class Says>
hn::Vec<hn::RebindToUnsigned<D>> words_of(const LaneQueries<D>& lanes, const Says& says) {
  hn::TFromD<hn::RebindToUnsigned<D>> x[lanes_in<D>];
  for (std::size_t j = 0; j < lanes.size(); ++j) {
    x[j] = static_cast<hn::TFromD<hn::RebindToUnsigned<D>>>(lanes[j].is_padding() ? 0x7f7f7f : says(lanes[j]));
  }
  return hn::LoadU(hn::RebindToUnsigned<D>(), x);
}
template <class D>
DecidedLanes<D> decided_by(Script::Step step, const LaneQueries<D>& lanes) {
  script->note_decided(step, lanes);
  return {mask_of<D>(lanes, [&](const LaneQuery& q) { return script->decides(step, q) && script->is_separated(q); }),
          mask_of<D>(lanes, [&](const LaneQuery& q) { return script->decides(step, q) && !script->is_separated(q); })};
}

// The coarse step.
template <class D, bool fused>
struct CoarseMargins {
  LaneQueries<D> lanes, S, E, r;
};
template <class D, bool fused>
CoarseMargins<D, fused> coarse_margins(const Problem<Lanes<D, fused>>& q) {
  const LaneQueries<D> lanes = lanes_of(q);
  return {lanes, lanes, lanes, lanes};
}
template <class D, bool fused>
struct CoarseLimits {
  CoarseLimits(const LaneQueries<D>&, const LaneQueries<D>&) {}
  static hn::Mask<D> in_deep_range(const LaneQueries<D>& lanes, const LaneQueries<D>&) {
    return mask_of<D>(lanes, [](const LaneQuery& q) { return script->is_in_deep_range(q); });
  }
};
template <class D, bool fused>
DecidedLanes<D> coarse_step(const CoarseMargins<D, fused>& m, const CoarseLimits<D, fused>&) {
  return decided_by<D>(Script::coarse_in_double, m.lanes);
}
template <class D, bool fused>
DecidedLanes<D> coarse_step(D, const Problem<Lanes<D, fused>>& q) {
  return decided_by<D>(Script::coarse, lanes_of(q));
}
template <class D, bool fused>
hn::Vec<hn::RebindToUnsigned<D>> coarsely_known(D, const CoarseMargins<D, fused>& m, const CoarseLimits<D, fused>&) {
  script->note_told(Script::coarse_in_double, m.lanes);
  return words_of<D>(m.lanes, [](const LaneQuery& q) { return script->known(Script::coarse_in_double, q); });
}

template <class Real>
struct SphereBox {
  SphereBox(Real px, Real py, Real pz, Real r) { script->check_sphere(px, py, pz, r); }
};
template <class D>
struct BoxStep {
  explicit BoxStep(const SphereBox<hn::TFromD<D>>&) {}
  static bool all_beyond(const Problem<Lanes<D>>& q) {
    const LaneQueries<D> lanes = lanes_of(q);
    bool all = true;
    for (const LaneQuery& lane : lanes) all &= !lane.is_padding() && script->decides(Script::box, lane);
    if (all) script->note_decided(Script::box, lanes);
    return all;
  }
};

template <class D>
struct FineStep {
  struct Answer {
    DecidedLanes<D> decided;
    hn::Vec<hn::RebindToUnsigned<D>> known;
  };
  LaneQueries<D> lanes;
  FineStep(D, const Problem<Lanes<D>>& q, bool open) : lanes(lanes_of(q)) { script->check_sphere_kind(open); }
  hn::Mask<D> is_valid() const {
    return mask_of<D>(lanes, [](const LaneQuery& q) { return script->is_surely_valid(q); });
  }
  hn::Mask<D> is_sound() const {
    return mask_of<D>(lanes, [](const LaneQuery& q) { return script->is_in_fine_range(q); });
  }
  // A query that is not sound may have any answer.
  Answer answer() const {
    const auto is_sound = [](const LaneQuery& q) {
      return script->is_surely_valid(q) && (!script->is_wide || script->is_in_fine_range(q));
    };
    LaneQueries<D> sound = lanes;
    for (LaneQuery& lane : sound) {
      if (!lane.is_padding() && !is_sound(lane)) lane = LaneQuery::padding();
    }
    Answer found{decided_by<D>(Script::fine, sound), {}};
    script->note_told(Script::fine, sound);
    found.known = words_of<D>(sound, [](const LaneQuery& q) { return script->known(Script::fine, q); });
    return found;
  }
};

enum class DeepComparison : std::uint8_t { vertex_radius, vertex_sides, edge_radius, edge_side, plane_radius };
inline constexpr std::size_t comparing_count = 5;
template <class D>
struct DeepStep {
  struct Answer {
    hn::Mask<D> holds, fails;
  };
  LaneQueries<D> lanes;
  DeepStep(D, const Problem<Lanes<D>>& q, bool open) : lanes(lanes_of(q)) { script->check_sphere_kind(open); }
  template <DeepComparison what>
  Answer answer() const {
    constexpr int group = what == DeepComparison::vertex_sides || what == DeepComparison::edge_side
                              ? KnownResults::sides
                              : KnownResults::radius;
    constexpr int first = what == DeepComparison::plane_radius                                       ? 3
                          : what == DeepComparison::edge_radius || what == DeepComparison::edge_side ? 4
                                                                                                     : 0;
    script->note_deep(group, first, lanes);
    return {mask_of<D>(lanes, [](const LaneQuery& q) { return script->deep(group, first + q.turn, q).holds; }),
            mask_of<D>(lanes, [](const LaneQuery& q) { return script->deep(group, first + q.turn, q).fails; })};
  }
};

// Scaled numbers are 2^20 times as great.
template <class D>
struct ScaledToRange {
  hn::Vec<D> number[13];
  hn::Mask<D> useful;
  ScaledToRange(D d, const Problem<Lanes<D>>& q)
      : number{q.a.x.v, q.a.y.v, q.a.z.v, q.b.x.v, q.b.y.v, q.b.z.v, q.c.x.v,
               q.c.y.v, q.c.z.v, q.p.x.v, q.p.y.v, q.p.z.v, q.r.v},
        useful(mask_of<D>(lanes_of(q), [](const LaneQuery& lane) { return script->can_be_scaled(lane); })) {
    for (auto& x : number) x = hn::Mul(x, hn::Set(d, 0x1p20));
  }
};

template <class D>
struct Conservative {
  struct Answer {
    hn::Mask<D> separated, unknown;
  };
  static Answer answer(const Problem<Lanes<D, false>>& q) { return said(Script::conservative, lanes_of(q)); }
  static Answer answer_scaled(const Problem<Lanes<D, false>>& q) {
    return said(Script::conservative_scaled, lanes_of(q));
  }
  static Answer said(Script::Step step, const LaneQueries<D>& lanes) {
    script->note_decided(step, lanes);
    return {mask_of<D>(lanes, [&](const LaneQuery& q) { return script->decides(step, q) && script->is_separated(q); }),
            mask_of<D>(lanes, [&](const LaneQuery& q) { return !script->decides(step, q); })};
  }
};

template <class D>
struct PairStep {
  bool is_separated = false, is_contact = false;
  PairStep(const hn::TFromD<D>* triangle, const hn::TFromD<D>* sphere) {
    double q[13];
    for (int k = 0; k < 9; ++k) q[k] = static_cast<double>(triangle[k]);
    for (int k = 9; k < 13; ++k) q[k] = static_cast<double>(sphere[k - 9]);
    const std::array<LaneQuery, 1> lane = {script->query_of(q)};
    script->note_decided(Script::coarse, lane);
    if (!script->decides(Script::coarse, lane[0])) return;
    (script->is_separated(lane[0]) ? is_separated : is_contact) = true;
  }
  bool separated() const { return is_separated; }
  bool contact() const { return is_contact; }
};

inline bool asked_last_step(const double (&q)[13], Question question, KnownResults known, int widest) {
  return script->last_step(q, question == Question::open_sphere, known.bits, widest);
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
