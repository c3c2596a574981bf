// Queries in the lanes of Highway's vectors, one each, for the instruction set that foreach_target is compiling: the
// number type of a predicate's formulae, and the walk over a batch. The including file has defined AXISCERT_PER_TARGET.
#include <cstring>

#include "kernel/base/per_target.h"
#include "kernel/names.h"
#include "kernel/query.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The number type of the formulae: N queries at once, one rounding per operation.
template <class V>
struct Lanes {
  V v;
  Lanes() = default;
  AXISCERT_INLINE Lanes(V lanes) : v(lanes) {}
  AXISCERT_INLINE explicit Lanes(double everywhere)
      : v(hn::Set(hn::DFromV<V>(), static_cast<hn::TFromV<V>>(everywhere))) {}
  AXISCERT_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return {hn::Add(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return {hn::Sub(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return {hn::Mul(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) { return {hn::Div(a.v, b.v)}; }
};

template <class D>
using LanesOf = Lanes<hn::Vec<D>>;

// The lanes in which something holds, and what is made of it: kernel/moving_sphere/branchless.h has the same for one
// number.
template <class V>
struct ComparisonLanes {
  hn::Mask<hn::DFromV<V>> m;
};
template <class V>
AXISCERT_INLINE ComparisonLanes<V> operator>(const Lanes<V>& a, const Lanes<V>& b) {
  return {hn::Gt(a.v, b.v)};
}
template <class V>
AXISCERT_INLINE ComparisonLanes<V> operator>=(const Lanes<V>& a, const Lanes<V>& b) {
  return {hn::Ge(a.v, b.v)};
}
template <class V>
AXISCERT_INLINE ComparisonLanes<V> both(const ComparisonLanes<V>& a, const ComparisonLanes<V>& b) {
  return {hn::And(a.m, b.m)};
}
template <class V>
AXISCERT_INLINE ComparisonLanes<V> either(const ComparisonLanes<V>& a, const ComparisonLanes<V>& b) {
  return {hn::Or(a.m, b.m)};
}
template <class V>
AXISCERT_INLINE ComparisonLanes<V> opposite(const ComparisonLanes<V>& a) {
  return {hn::Not(a.m)};
}
template <class V>
AXISCERT_INLINE Lanes<V> chosen(const ComparisonLanes<V>& where, const Lanes<V>& yes, const Lanes<V>& no) {
  return {hn::IfThenElse(where.m, yes.v, no.v)};
}
template <class V>
AXISCERT_INLINE Lanes<V> square_root(const Lanes<V>& a) {
  return {hn::Sqrt(a.v)};
}
template <class V>
AXISCERT_INLINE Lanes<V> magnitude(const Lanes<V>& a) {
  return {hn::Abs(a.v)};
}

// Spreads the low eight bits over eight bytes of 0 or 1: the verdicts `contact` and `separated`.
AXISCERT_INLINE void store_verdicts(std::uint8_t bits, Verdict* out) {
  const std::uint64_t each = (bits * 0x0101010101010101ull) & 0x8040201008040201ull;
  const std::uint64_t ones = ((each + 0x7f7f7f7f7f7f7f7full) >> 7) & 0x0101010101010101ull;
  std::memcpy(out, &ones, sizeof ones);
}

// Bit j is lane j.
template <class D>
AXISCERT_INLINE std::uint64_t bits_of_mask(D d, hn::Mask<D> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  std::uint64_t bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return bits;
}

// Runs body on a padded copy of the queries after the last whole block, so that no lane reads outside the batch.
template <class Real, std::size_t block, class Body>
void with_padded_tail(const QueryColumns<Real>& batch, std::size_t begin, Body&& body) {
  Real storage[most_columns][block];
  QueryColumns<Real> tail;
  tail.size = batch.size - begin;
  tail.count = batch.count;
  for (std::size_t k = 0; k < tail.count; ++k) {
    std::memset(storage[k], 0, sizeof storage[k]);
    std::memcpy(storage[k], batch.column[k] + begin, tail.size * sizeof(Real));
    tail.column[k] = storage[k];
  }
  body(tail);
}

// Verdicts of a batch by Mask::separated(from, i), the bits of the lanes that are separated among those from query i
// on.
template <class Mask, class Real>
AXISCERT_INLINE void verdicts_in_lanes(const QueryColumns<Real>& batch, Verdict* out) {
  constexpr std::size_t lanes = hn::MaxLanes(hn::ScalableTag<Real>());
  constexpr std::size_t block = lanes > 8 ? lanes : 8;
  const auto one_block = [](const QueryColumns<Real>& from, std::size_t i, Verdict* to) HWY_ATTR {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < block; k += lanes) bits |= Mask::separated(from, i + k) << k;
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

// Calls one_vector(from, at, i, count) for each vector of a batch: the lanes from query `at` of `from` on, of which
// `count` are queries i, i + 1, ... of the batch.
template <class Real, std::size_t lanes = hn::MaxLanes(hn::ScalableTag<Real>()), class OneVector>
AXISCERT_INLINE void for_each_vector(const QueryColumns<Real>& batch, OneVector&& one_vector) {
  std::size_t i = 0;
  for (; i + lanes <= batch.size; i += lanes) one_vector(batch, i, i, lanes);
  if (i == batch.size) return;
  with_padded_tail<Real, lanes>(batch, i,
                                [&](const QueryColumns<Real>& tail) HWY_ATTR { one_vector(tail, 0, i, tail.size); });
}

// Writes the first `count` lanes to queries i, i + 1, ... of a column.
template <class D, class Real = hn::TFromD<D>>
AXISCERT_INLINE void store_lanes(D d, hn::Vec<D> v, std::size_t count, Real* out) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  if (count == lanes) {
    hn::StoreU(v, d, out);
    return;
  }
  Real buffer[lanes];
  hn::StoreU(v, d, buffer);
  std::memcpy(out, buffer, count * sizeof(Real));
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();
