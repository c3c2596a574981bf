// The textbook and its form with cofactors on every instruction set.
#include "kernel/boxes/simd.h"
#include "kernel/kernel.h"
#include "kernel/formulae_kernel.h"

#define HWY_COMPILE_ALL_ATTAINABLE  // the narrow sets too: `--target` must reach each of them
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/boxes/simd_boxes.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/boxes/relative.h"
#include "kernel/sides_in_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {

// BoxPair over lanes.
template <class T>
struct LaneBox {
  Vec3<T> centre;
  std::array<T, 3> half;
  std::array<Vec3<T>, 3> axis;
};
template <class T>
struct LaneBoxes {
  LaneBox<T> a, b;
};

struct BoxLoad {
  template <class D, class Real = hn::TFromD<D>>
  AXISCERT_INLINE static LaneBoxes<LanesOf<D>> problem(D d, const QueryColumns<Real>& batch, std::size_t i) {
    using T = LanesOf<D>;
    const auto number = [&](std::size_t k) HWY_ATTR { return T{hn::LoadU(d, batch.column[k] + i)}; };
    const auto box = [&](std::size_t k) HWY_ATTR {
      return LaneBox<T>{{number(k), number(k + 1), number(k + 2)},
                        {number(k + 3), number(k + 4), number(k + 5)},
                        {{{number(k + 6), number(k + 7), number(k + 8)},
                          {number(k + 9), number(k + 10), number(k + 11)},
                          {number(k + 12), number(k + 13), number(k + 14)}}}};
    };
    return {box(0), box(15)};
  }
};

// An axis is one comparison, and any separates.
template <class D, class F>
struct BoxVerdict {
  hn::Mask<D> any;
  template <class T>
  AXISCERT_INLINE void operator()(std::size_t i, const T& lhs, const T& rhs) {
    any = hn::Or(any, comparison_holds<F>(i, lhs, rhs).m);
  }
};
template <class F>
struct BoxesSeparated {
  template <class Real>
  AXISCERT_INLINE static std::uint64_t separated(const QueryColumns<Real>& batch, std::size_t i) {
    const hn::ScalableTag<Real> d;
    BoxVerdict<decltype(d), F> sink{hn::MaskFromVec(hn::Zero(d))};
    F::template comparisons<LanesOf<decltype(d)>>(BoxLoad::problem(d, batch, i), sink);
    return bits_of_mask(d, sink.any);
  }
};
template <class F, class Real>
void box_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  verdicts_in_lanes<BoxesSeparated<F>>(batch, out);
}
template <class F, class Real>
Implementation<Real> box_implementation() {
  return {box_verdicts<F, Real>, explain_in_lanes<F, BoxLoad, Real>};
}

Implementation<float> box_textbook32() { return box_implementation<box_frame::Textbook, float>(); }
Implementation<double> box_textbook64() { return box_implementation<box_frame::Textbook, double>(); }
Implementation<float> box_cofactor32() { return box_implementation<box_frame::Cofactor, float>(); }
Implementation<double> box_cofactor64() { return box_implementation<box_frame::Cofactor, double>(); }

}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
HWY_EXPORT(box_textbook32);
HWY_EXPORT(box_textbook64);
HWY_EXPORT(box_cofactor32);
HWY_EXPORT(box_cofactor64);

const LaneForms& boxes::simd_textbook() {
  static const LaneForms forms([] { return HWY_DYNAMIC_DISPATCH(box_textbook32)(); },
                               [] { return HWY_DYNAMIC_DISPATCH(box_textbook64)(); });
  return forms;
}
const LaneForms& boxes::simd_cofactor() {
  static const LaneForms forms([] { return HWY_DYNAMIC_DISPATCH(box_cofactor32)(); },
                               [] { return HWY_DYNAMIC_DISPATCH(box_cofactor64)(); });
  return forms;
}

}  // namespace axiscert
#endif
