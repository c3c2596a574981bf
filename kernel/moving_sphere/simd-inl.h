// Formulae of the moving sphere over Highway's vectors, one query per lane, for the instruction set that foreach_target
// is compiling. The including file has defined AXISCERT_PER_TARGET and included the formulae.
#include "kernel/lanes-inl.h"
#include "kernel/moving_sphere/names.h"
#include "kernel/plain_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {

// MovingQuery over lanes.
template <class T>
struct MovingLanes {
  Vec3<T> a, b, c, p, d;
  T r;
};
template <class D, class Real = hn::TFromD<D>>
AXISCERT_INLINE MovingLanes<LanesOf<D>> load_motion(D d, const QueryColumns<Real>& batch, std::size_t i) {
  using T = LanesOf<D>;
  const auto lanes = [&](std::size_t k) HWY_ATTR { return T{hn::LoadU(d, batch.column[k] + i)}; };
  return {{lanes(0), lanes(1), lanes(2)},   {lanes(3), lanes(4), lanes(5)},    {lanes(6), lanes(7), lanes(8)},
          {lanes(9), lanes(10), lanes(11)}, {lanes(12), lanes(13), lanes(14)}, lanes(15)};
}

// i is a constant to the compiler wherever a sink is called.
template <class F, class T>
AXISCERT_INLINE auto motion_holds(std::size_t i, const T& lhs, const T& rhs) {
  return has_bit(nonstrict_comparisons<F>(), i) ? lhs >= rhs : lhs > rhs;
}

// Keeps, for the current axis, the lanes in which every comparison so far holds, and the lanes in which some axis
// separates. The comparisons of an axis are emitted one after the other.
template <class D, class F>
struct MotionVerdict {
  hn::Mask<D> any, axis;
  template <class T>
  AXISCERT_INLINE void operator()(std::size_t i, const T& lhs, const T& rhs) {
    const auto holds = motion_holds<F>(i, lhs, rhs).m;
    axis = has_bit(moving_sphere::side_bits, i) ? hn::And(axis, holds) : holds;
    if (!has_bit(moving_sphere::side_bits, i + 1)) any = hn::Or(any, axis);
  }
};
template <class F>
struct SeparatedByComparisons {
  template <class Real>
  AXISCERT_INLINE static std::uint64_t separated(const QueryColumns<Real>& batch, std::size_t i) {
    const hn::ScalableTag<Real> d;
    const auto none = hn::MaskFromVec(hn::Zero(d));
    MotionVerdict<decltype(d), F> sink{none, none};
    F::template comparisons<LanesOf<decltype(d)>>(load_motion(d, batch, i), sink);
    return bits_of_mask(d, sink.any);
  }
};

// Writes the sides, and collects the comparison bits of each lane in words of its width: two of them for binary32.
template <class D, class F>
struct MotionSides {
  using Real = hn::TFromD<D>;
  using Words = hn::RebindToUnsigned<D>;
  using Word = hn::TFromD<Words>;
  static constexpr std::size_t lanes = hn::MaxLanes(D()), width = 8 * sizeof(Real);
  Answers<Real>& out;
  std::size_t first, count;  // the first query, and the number of lanes that are queries
  hn::Vec<Words> low, high;

  template <class T>
  AXISCERT_INLINE void operator()(std::size_t i, const T& lhs, const T& rhs) {
    store_lanes(D(), lhs.v, count, out.lhs[i].data() + first);
    store_lanes(D(), rhs.v, count, out.rhs[i].data() + first);
    const auto bit = hn::BitCast(D(), hn::Set(Words(), one_bit<Word>(i % width)));
    const auto held = hn::BitCast(Words(), hn::IfThenElseZero(motion_holds<F>(i, lhs, rhs).m, bit));
    if (i < width) low = hn::Or(low, held);
    else high = hn::Or(high, held);
  }
  AXISCERT_INLINE void store_bits() const {
    Word least[lanes], greatest[lanes];
    hn::StoreU(low, Words(), least);
    hn::StoreU(high, Words(), greatest);
    for (std::size_t j = 0; j < count; ++j) {
      ComparisonBits bits = least[j];
      if constexpr (width < 64) bits |= static_cast<ComparisonBits>(greatest[j]) << width;
      out.bits[first + j] = bits;
    }
  }
};

template <class F, class Real>
void motion_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  verdicts_in_lanes<SeparatedByComparisons<F>>(batch, out);
}
template <class F, class Real>
void motion_explain(const QueryColumns<Real>& batch, Answers<Real>& out) {
  using D = hn::ScalableTag<Real>;
  for_each_vector(batch,
                  [&](const QueryColumns<Real>& from, std::size_t at, std::size_t i, std::size_t count) HWY_ATTR {
                    const auto zero = hn::Zero(hn::RebindToUnsigned<D>());
                    MotionSides<D, F> sink{out, i, count, zero, zero};
                    F::template comparisons<LanesOf<D>>(load_motion(D(), from, at), sink);
                    sink.store_bits();
                  });
}
template <class F, class Real>
Implementation<Real> motion_implementation() {
  return {motion_verdicts<F, Real>, motion_explain<F, Real>};
}

// A form M with first(query), which has a verdict and no comparisons.
template <class M>
struct SeparatedByFirstHit {
  template <class Real>
  AXISCERT_INLINE static std::uint64_t separated(const QueryColumns<Real>& batch, std::size_t i) {
    const hn::ScalableTag<Real> d;
    const auto hit = M::template first<LanesOf<decltype(d)>>(load_motion(d, batch, i));
    return bits_of_mask(d, hn::Not(hit.contact.m));
  }
};
template <class M, class Real>
void first_hit_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  verdicts_in_lanes<SeparatedByFirstHit<M>>(batch, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();
