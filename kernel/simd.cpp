#include "kernel/simd.h"

#include <cstring>
#include <mutex>

#include "kernel/evaluate.h"

#define HWY_COMPILE_ALL_ATTAINABLE  // the narrow sets too: `--target` must reach each
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/simd.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/formulae.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The number type of the formulae: N queries at once, one rounding an operation.
template <class V>
struct Lanes {
  V v;
  AXISCERT_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return {hn::Add(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return {hn::Sub(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return {hn::Mul(a.v, b.v)}; }
};

template <class D>
using LanesOf = Lanes<hn::Vec<D>>;

template <class D, class Real = hn::TFromD<D>>
AXISCERT_INLINE Centred<LanesOf<D>> load(D d, const QueryColumns<Real>& batch, std::size_t i) {
  using T = LanesOf<D>;
  const auto lanes = [&](std::size_t k) HWY_ATTR { return T{hn::LoadU(d, batch.column[k] + i)}; };
  return centred<T>({lanes(0), lanes(1), lanes(2)}, {lanes(3), lanes(4), lanes(5)}, {lanes(6), lanes(7), lanes(8)},
                    {lanes(9), lanes(10), lanes(11)}, lanes(12));
}

template <Strictness strictness, class T>
AXISCERT_INLINE auto holds(Comparison which, const T& lhs, const T& rhs) {
  const bool nonstrict = strictness == Strictness::nonstrict && !info(which).is_radius;
  return nonstrict ? hn::Ge(lhs.v, rhs.v) : hn::Gt(lhs.v, rhs.v);
}

// Keeps, per axis, the lanes in which every comparison so far holds; comparisons of an axis come together.
template <class D, Strictness strictness>
struct VerdictSink {
  using M = hn::Mask<D>;
  M any, axis;
  template <class T>
  AXISCERT_INLINE void operator()(Comparison which, const T& lhs, const T& rhs) {
    const M m = holds<strictness>(which, lhs, rhs);
    axis = info(which).is_radius ? m : hn::And(axis, m);
    const bool last = static_cast<std::size_t>(which) + 1 == comparison_count ||
                      comparisons[static_cast<std::size_t>(which) + 1].is_radius;
    if (last) any = hn::Or(any, axis);
  }
};

// Spreads the low eight bits over eight bytes of 0 or 1: the verdicts `contact` and `separated`.
AXISCERT_INLINE void store_verdicts(std::uint8_t bits, Verdict* out) {
  const std::uint64_t each = (bits * 0x0101010101010101ull) & 0x8040201008040201ull;
  const std::uint64_t ones = ((each + 0x7f7f7f7f7f7f7f7full) >> 7) & 0x0101010101010101ull;
  std::memcpy(out, &ones, sizeof ones);
}

template <class Real, Strictness strictness>
AXISCERT_INLINE std::uint64_t separated_mask(const QueryColumns<Real>& batch, std::size_t i) {
  const hn::ScalableTag<Real> d;
  const auto none = hn::MaskFromVec(hn::Zero(d));
  VerdictSink<decltype(d), strictness> sink{none, none};
  published_comparisons(load(d, batch, i), LanesOf<decltype(d)>{hn::Zero(d)}, sink);
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, sink.any, bytes);
  std::uint64_t bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return bits;
}

// Runs body on a padded copy of what is left after whole blocks, so that no lane reads outside the batch.
template <class Real, std::size_t block, class Body>
void with_padded_tail(const QueryColumns<Real>& batch, std::size_t begin, Body&& body) {
  Real storage[coordinate_count][block] = {};
  QueryColumns<Real> tail{{}, batch.size - begin};
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    std::memcpy(storage[k], batch.column[k] + begin, tail.size * sizeof(Real));
    tail.column[k] = storage[k];
  }
  body(tail);
}

template <class Real, Strictness strictness>
void verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  constexpr std::size_t lanes = hn::MaxLanes(hn::ScalableTag<Real>());
  constexpr std::size_t block = lanes > 8 ? lanes : 8;
  const auto one_block = [](const QueryColumns<Real>& from, std::size_t i, Verdict* to) HWY_ATTR {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < block; k += lanes) bits |= separated_mask<Real, strictness>(from, i + k) << k;
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

template <class D, Strictness strictness>
struct ExplainSink {
  using Real = hn::TFromD<D>;
  static constexpr std::size_t lanes = hn::MaxLanes(D());
  Answers<Real>& out;
  std::size_t i, count;  // first query and how many of the lanes are queries
  std::array<ComparisonBits, lanes> bits{};

  template <class T>
  AXISCERT_INLINE void operator()(Comparison which, const T& lhs, const T& rhs) {
    const auto k = static_cast<std::size_t>(which);
    store(lhs.v, out.lhs[k]);
    store(rhs.v, out.rhs[k]);
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(D(), holds<strictness>(which, lhs, rhs), bytes);
    for (std::size_t j = 0; j < lanes; ++j) {
      bits[j] |= static_cast<ComparisonBits>(((bytes[j / 8] >> (j % 8)) & 1u) << k);
    }
  }
  template <class V>
  AXISCERT_INLINE void store(const V& v, std::vector<Real>& column) {
    Real buffer[lanes];
    hn::StoreU(v, D(), buffer);
    std::memcpy(column.data() + i, buffer, count * sizeof(Real));
  }
};

// The vector that begins at `at` of `from`, into entries i to i + count of `out`.
template <class Real, Strictness strictness>
AXISCERT_INLINE void explain_vector(const QueryColumns<Real>& from, std::size_t at, std::size_t i, std::size_t count,
                                    Answers<Real>& out) {
  using D = hn::ScalableTag<Real>;
  ExplainSink<D, strictness> sink{out, i, count};
  published_comparisons(load(D(), from, at), LanesOf<D>{hn::Zero(D())}, sink);
  for (std::size_t j = 0; j < count; ++j) out.bits[i + j] = sink.bits[j];
}

template <class Real, Strictness strictness>
void explain(const QueryColumns<Real>& batch, Answers<Real>& out) {
  constexpr std::size_t lanes = hn::MaxLanes(hn::ScalableTag<Real>());
  std::size_t i = 0;
  for (; i + lanes <= batch.size; i += lanes) explain_vector<Real, strictness>(batch, i, i, lanes, out);
  if (i == batch.size) return;
  with_padded_tail<Real, lanes>(batch, i, [&](const QueryColumns<Real>& tail) HWY_ATTR {
    explain_vector<Real, strictness>(tail, 0, i, tail.size, out);
  });
}

template <class Real>
Implementation<Real> implementation(Strictness strictness) {
  return strictness == Strictness::strict
             ? Implementation<Real>{verdicts<Real, Strictness::strict>, explain<Real, Strictness::strict>}
             : Implementation<Real>{verdicts<Real, Strictness::nonstrict>, explain<Real, Strictness::nonstrict>};
}
Implementation<float> implementation32(Strictness s) { return implementation<float>(s); }
Implementation<double> implementation64(Strictness s) { return implementation<double>(s); }

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
namespace {

HWY_EXPORT(implementation32);
HWY_EXPORT(implementation64);

struct Choice {
  std::string name;
  Implementation<float> binary32[2];
  Implementation<double> binary64[2];
};

// Highway keeps its choice in a global: walk through the sets once, keep the pointers, and leave it as it was.
std::vector<Choice> collect() {
  std::vector<Choice> choices;
  // HWY_SCALAR is no instruction set: the scalar reference stands for it.
  const std::int64_t supported = hwy::SupportedTargets() & HWY_TARGETS & ~std::int64_t{HWY_SCALAR};
  for (std::int64_t rest = supported; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;  // a lower bit is a better instruction set
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    Choice choice{hwy::TargetName(target), {}, {}};
    for (const Strictness s : {Strictness::strict, Strictness::nonstrict}) {
      choice.binary32[static_cast<int>(s)] = HWY_DYNAMIC_DISPATCH(implementation32)(s);
      choice.binary64[static_cast<int>(s)] = HWY_DYNAMIC_DISPATCH(implementation64)(s);
    }
    choices.push_back(choice);
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return choices;
}

const std::vector<Choice>& choices() {
  static const std::vector<Choice> all = collect();
  return all;
}

}  // namespace

std::vector<std::string> simd_targets() {
  std::vector<std::string> names;
  for (const Choice& choice : choices()) names.push_back(choice.name);
  return names;
}

template <class Real>
Implementation<Real> simd_implementation(Strictness strictness, std::string_view target) {
  for (const Choice& choice : choices()) {
    if (choice.name != target) continue;
    if constexpr (sizeof(Real) == 4) return choice.binary32[static_cast<int>(strictness)];
    else return choice.binary64[static_cast<int>(strictness)];
  }
  return {};
}
template Implementation<float> simd_implementation<float>(Strictness, std::string_view);
template Implementation<double> simd_implementation<double>(Strictness, std::string_view);

}  // namespace axiscert
#endif
