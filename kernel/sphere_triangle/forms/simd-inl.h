// A set of ring formulae over Highway vectors, one query per lane, for the instruction set that foreach_target is
// compiling. The including file has defined AXISCERT_PER_TARGET and included the formulae.
#include <cstring>

#include "kernel/sphere_triangle/query.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The number type of the formulae: N queries at once, one rounding per operation.
template <class V>
struct Lanes {
  V v;
  AXISCERT_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return {hn::Add(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return {hn::Sub(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return {hn::Mul(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) { return {hn::Div(a.v, b.v)}; }
};

template <class D>
using LanesOf = Lanes<hn::Vec<D>>;

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

template <Strictness strictness, class T>
AXISCERT_INLINE auto lanes_hold(Comparison which, const T& lhs, const T& rhs) {
  const bool nonstrict = strictness == Strictness::nonstrict && !info(which).is_radius;
  return nonstrict ? hn::Ge(lhs.v, rhs.v) : hn::Gt(lhs.v, rhs.v);
}

// Keeps, for the current axis, the lanes in which every comparison so far holds, and the lanes in which some axis
// separates. The comparisons of an axis are emitted one after the other.
template <class D, Strictness strictness>
struct VerdictSink {
  using M = hn::Mask<D>;
  M any, axis;
  template <class T>
  AXISCERT_INLINE void operator()(Comparison which, const T& lhs, const T& rhs) {
    const M m = lanes_hold<strictness>(which, lhs, rhs);
    axis = info(which).is_radius ? m : hn::And(axis, m);
    const bool last = index_of(which) + 1 == comparison_count || comparisons[index_of(which) + 1].is_radius;
    if (last) any = hn::Or(any, axis);
  }
};

// Spreads the low eight bits over eight bytes of 0 or 1: the verdicts `contact` and `separated`.
AXISCERT_INLINE void store_verdicts(std::uint8_t bits, Verdict* out) {
  const std::uint64_t each = (bits * 0x0101010101010101ull) & 0x8040201008040201ull;
  const std::uint64_t ones = ((each + 0x7f7f7f7f7f7f7f7full) >> 7) & 0x0101010101010101ull;
  std::memcpy(out, &ones, sizeof ones);
}

template <class F, class Real, Strictness strictness>
AXISCERT_INLINE std::uint64_t separated_mask(const QueryColumns<Real>& batch, std::size_t i) {
  const hn::ScalableTag<Real> d;
  const auto none = hn::MaskFromVec(hn::Zero(d));
  VerdictSink<decltype(d), strictness> sink{none, none};
  F::comparisons(load(d, batch, i), sink);
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, sink.any, bytes);
  std::uint64_t bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return bits;
}

// Runs body on a padded copy of the queries after the last whole block, so that no lane reads outside the batch.
template <class Real, std::size_t block, class Body>
void with_padded_tail(const QueryColumns<Real>& batch, std::size_t begin, Body&& body) {
  Real storage[coordinate_count][block] = {};
  QueryColumns<Real> tail;
  tail.size = batch.size - begin;
  tail.count = coordinate_count;
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    std::memcpy(storage[k], batch.column[k] + begin, tail.size * sizeof(Real));
    tail.column[k] = storage[k];
  }
  body(tail);
}

template <class F, class Real, Strictness strictness>
void verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  constexpr std::size_t lanes = hn::MaxLanes(hn::ScalableTag<Real>());
  constexpr std::size_t block = lanes > 8 ? lanes : 8;
  const auto one_block = [](const QueryColumns<Real>& from, std::size_t i, Verdict* to) HWY_ATTR {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < block; k += lanes) bits |= separated_mask<F, Real, strictness>(from, i + k) << k;
    for (std::size_t k = 0; k < block; k += 8) store_verdicts(static_cast<std::uint8_t>(bits >> k), to + k);
  };
  std::size_t i = 0;
  for (; i + block <= batch.size; i += block) one_block(batch, i, out + i);
  if (i == batch.size) return;
  with_padded_tail<Real, block>(batch, i, [&](const QueryColumns<Real>& tail) HWY_ATTR {
    Verdict padded[block];
    one_block(tail, 0, padded);
    std::memcpy(out + i, padded, tail.size * sizeof(Verdict));
  });
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
    const auto held = hn::IfThenElseZero(lanes_hold<strictness>(which, lhs, rhs), hn::BitCast(D(), bit));
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
  constexpr std::size_t lanes = hn::MaxLanes(D());
  const auto one_vector = [](const QueryColumns<Real>& from, std::size_t at, ComparisonBits* to, std::size_t count)
                              HWY_ATTR {
                                BitsSink<D, strictness> sink;
                                F::comparisons(load(D(), from, at), sink);
                                sink.store(to, count);
                              };
  std::size_t i = 0;
  for (; i + lanes <= batch.size; i += lanes) one_vector(batch, i, out + i, lanes);
  if (i == batch.size) return;
  with_padded_tail<Real, lanes>(
      batch, i, [&](const QueryColumns<Real>& tail) HWY_ATTR { one_vector(tail, 0, out + i, tail.size); });
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
    store_side(lhs.v, out.lhs[k]);
    store_side(rhs.v, out.rhs[k]);
    Base::operator()(which, lhs, rhs);
  }
  template <class V>
  AXISCERT_INLINE void store_side(const V& v, std::vector<Real>& column) {
    if (count == Base::lanes) {
      hn::StoreU(v, D(), column.data() + i);
      return;
    }
    Real buffer[Base::lanes];
    hn::StoreU(v, D(), buffer);
    std::memcpy(column.data() + i, buffer, count * sizeof(Real));
  }
};

// Evaluates the vector that begins at query `at` of `from` and writes it to entries i to i + count of `out`.
template <class F, class Real, Strictness strictness>
AXISCERT_INLINE void explain_vector(const QueryColumns<Real>& from, std::size_t at, std::size_t i, std::size_t count,
                                    Answers<Real>& out) {
  using D = hn::ScalableTag<Real>;
  ExplainSink<D, strictness> sink(out, i, count);
  F::comparisons(load(D(), from, at), sink);
  sink.store(out.bits.data() + i, count);
}

template <class F, class Real, Strictness strictness>
void explain(const QueryColumns<Real>& batch, Answers<Real>& out) {
  constexpr std::size_t lanes = hn::MaxLanes(hn::ScalableTag<Real>());
  std::size_t i = 0;
  for (; i + lanes <= batch.size; i += lanes) explain_vector<F, Real, strictness>(batch, i, i, lanes, out);
  if (i == batch.size) return;
  with_padded_tail<Real, lanes>(batch, i, [&](const QueryColumns<Real>& tail) HWY_ATTR {
    explain_vector<F, Real, strictness>(tail, 0, i, tail.size, out);
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
