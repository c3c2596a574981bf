// A set of ring formulae over Highway vectors, one query per lane, for the instruction set that foreach_target is
// compiling. The including file has defined AXISCERT_PER_TARGET and included the formulae.
#include "kernel/lanes-inl.h"
#include "kernel/sphere_triangle/query.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {

template <class D, class Real = hn::TFromD<D>>
AXISCERT_INLINE Problem<LanesOf<D>> load(D d, const QueryColumns<Real>& batch, std::size_t i) {
  using T = LanesOf<D>;
  const auto lanes = [&](std::size_t k) HWY_ATTR { return T{hn::LoadU(d, batch.column[k] + i)}; };
  return {{lanes(0), lanes(1), lanes(2)},
          {lanes(3), lanes(4), lanes(5)},
          {lanes(6), lanes(7), lanes(8)},
          {lanes(9), lanes(10), lanes(11)},
          lanes(12),
          T{hn::Zero(d)}};
}

// `which` is a constant to the compiler wherever a sink is called.
template <Strictness strictness, class T>
AXISCERT_INLINE auto lanes_hold(Comparison which, const T& lhs, const T& rhs) {
  const bool nonstrict = strictness == Strictness::nonstrict && !info(which).is_radius;
  return nonstrict ? lhs >= rhs : lhs > rhs;
}

// Keeps, for the current axis, the lanes in which every comparison so far holds, and the lanes in which some axis
// separates. The comparisons of an axis are emitted one after the other.
template <class D, Strictness strictness>
struct VerdictSink {
  ComparisonLanes<hn::Vec<D>> any, axis;
  template <class T>
  AXISCERT_INLINE void operator()(Comparison which, const T& lhs, const T& rhs) {
    const auto holds = lanes_hold<strictness>(which, lhs, rhs);
    axis = info(which).is_radius ? holds : both(axis, holds);
    const bool last = index_of(which) + 1 == comparison_count || comparisons[index_of(which) + 1].is_radius;
    if (last) any = either(any, axis);
  }
};

template <class F, Strictness strictness>
struct SeparatedByAxes {
  template <class Real>
  AXISCERT_INLINE static std::uint64_t separated(const QueryColumns<Real>& batch, std::size_t i) {
    const hn::ScalableTag<Real> d;
    const auto none = hn::MaskFromVec(hn::Zero(d));
    VerdictSink<decltype(d), strictness> sink{{none}, {none}};
    F::comparisons(load(d, batch, i), sink);
    return bits_of_mask(d, sink.any.m);
  }
};

template <class F, class Real, Strictness strictness>
void verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  verdicts_in_lanes<SeparatedByAxes<F, strictness>>(batch, out);
}

// Collects the comparison bits of each lane in a word of the lane's width.
template <class D, Strictness strictness>
struct BitsSink {
  using Real = hn::TFromD<D>;
  using Words = hn::RebindToUnsigned<D>;
  static constexpr std::size_t lanes = hn::MaxLanes(D());
  hn::Vec<Words> words;

  AXISCERT_INLINE BitsSink() : words(hn::Zero(Words())) {}
  template <class T>
  AXISCERT_INLINE void operator()(Comparison which, const T& lhs, const T& rhs) {
    const auto bit = hn::Set(Words(), one_bit<hn::TFromD<Words>>(which));
    const auto held = hn::IfThenElseZero(lanes_hold<strictness>(which, lhs, rhs).m, hn::BitCast(D(), bit));
    words = hn::Or(words, hn::BitCast(Words(), held));
  }
  AXISCERT_INLINE void store(ComparisonBits* out, std::size_t count) const {
    hn::TFromD<Words> each[lanes];
    hn::StoreU(words, Words(), each);
    for (std::size_t j = 0; j < count; ++j) out[j] = static_cast<ComparisonBits>(each[j]);
  }
};

template <class F, class Real, Strictness strictness>
void comparison_bits(const QueryColumns<Real>& batch, ComparisonBits* out) {
  using D = hn::ScalableTag<Real>;
  for_each_vector(batch,
                  [out](const QueryColumns<Real>& from, std::size_t at, std::size_t i, std::size_t count) HWY_ATTR {
                    BitsSink<D, strictness> sink;
                    F::comparisons(load(D(), from, at), sink);
                    sink.store(out + i, count);
                  });
}

template <class D, Strictness strictness>
struct ExplainSink : BitsSink<D, strictness> {
  using Base = BitsSink<D, strictness>;
  using Real = hn::TFromD<D>;
  Answers<Real>& out;
  std::size_t i, count;  // the first query, and the number of lanes that are queries

  AXISCERT_INLINE ExplainSink(Answers<Real>& answers, std::size_t first, std::size_t queries)
      : out(answers), i(first), count(queries) {}
  template <class T>
  AXISCERT_INLINE void operator()(Comparison which, const T& lhs, const T& rhs) {
    const auto k = index_of(which);
    store_lanes(D(), lhs.v, count, out.lhs[k].data() + i);
    store_lanes(D(), rhs.v, count, out.rhs[k].data() + i);
    Base::operator()(which, lhs, rhs);
  }
};

template <class F, class Real, Strictness strictness>
void explain(const QueryColumns<Real>& batch, Answers<Real>& out) {
  using D = hn::ScalableTag<Real>;
  for_each_vector(batch,
                  [&out](const QueryColumns<Real>& from, std::size_t at, std::size_t i, std::size_t count) HWY_ATTR {
                    ExplainSink<D, strictness> sink(out, i, count);
                    F::comparisons(load(D(), from, at), sink);
                    sink.store(out.bits.data() + i, count);
                  });
}

template <class F, class Real>
Implementation<Real> implementation(Strictness strictness) {
  const auto of = []<Strictness s>() {
    return Implementation<Real>{verdicts<F, Real, s>, explain<F, Real, s>, {}, {}, comparison_bits<F, Real, s>};
  };
  return strictness == Strictness::strict ? of.template operator()<Strictness::strict>()
                                          : of.template operator()<Strictness::nonstrict>();
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();
