// Formulae of the moving sphere over Highway's vectors, one query per lane, for the instruction set that foreach_target
// is compiling. The including file has defined AXISCERT_PER_TARGET and included the formulae.
#include "kernel/moving_sphere/names.h"
#include "kernel/sides_in_lanes-inl.h"

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

struct MotionLoad {
  template <class D, class Real = hn::TFromD<D>>
  AXISCERT_INLINE static MovingLanes<LanesOf<D>> problem(D d, const QueryColumns<Real>& batch, std::size_t i) {
    return load_motion(d, batch, i);
  }
};

// Keeps, for the current axis, the lanes in which every comparison so far holds, and the lanes in which some axis
// separates. The comparisons of an axis are emitted one after the other.
template <class D, class F>
struct MotionVerdict {
  hn::Mask<D> any, axis;
  template <class T>
  AXISCERT_INLINE void operator()(std::size_t i, const T& lhs, const T& rhs) {
    const auto holds = comparison_holds<F>(i, lhs, rhs).m;
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

template <class F, class Real>
void motion_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  verdicts_in_lanes<SeparatedByComparisons<F>>(batch, out);
}
template <class F, class Real>
Implementation<Real> motion_implementation() {
  return {motion_verdicts<F, Real>, explain_in_lanes<F, MotionLoad, Real>};
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
