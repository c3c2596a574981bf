// The steps compiled for every instruction set.
#include <limits>
#include <type_traits>

#include "hwy/cache_control.h"
#include "kernel/sphere_triangle/certified/exact_step.h"
#include "kernel/sphere_triangle/certified/steps.h"
#include "kernel/sphere_triangle/certified/thresholds.h"
#include "kernel/sphere_triangle/names.h"

#define HWY_COMPILE_ALL_ATTAINABLE  // the narrow sets too: tests have to reach each of them
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/sphere_triangle/certified/forms.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/base/geometry.h"
#include "kernel/sphere_triangle/certified/coarse_step-inl.h"
#include "kernel/sphere_triangle/certified/box_step-inl.h"
#include "kernel/sphere_triangle/certified/conservative_step-inl.h"
#include "kernel/sphere_triangle/certified/range_step-inl.h"
#include "kernel/sphere_triangle/certified/margins-inl.h"
#include "kernel/sphere_triangle/certified/fine_step-inl.h"
#include "kernel/sphere_triangle/certified/pairs-inl.h"
#include "kernel/sphere_triangle/certified/wrapped-inl.h"
#include "kernel/sphere_triangle/certified/deep_step-inl.h"
#include "kernel/sphere_triangle/certified/leftovers-inl.h"
#include "kernel/sphere_triangle/certified/open_comparisons-inl.h"
#include "kernel/sphere_triangle/certified/conservative_block-inl.h"
#include "kernel/sphere_triangle/certified/pair_step-inl.h"
#include "kernel/sphere_triangle/certified/block-inl.h"
#include "kernel/sphere_triangle/certified/outcodes-inl.h"
#include "kernel/sphere_triangle/certified/mesh-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::certified::HWY_NAMESPACE {
Forms forms() {
  using Floats = hn::ScalableTag<float>;
  using Doubles = hn::ScalableTag<double>;
  using OneFloat = hn::CappedTag<float, 1>;
  using OneDouble = hn::CappedTag<double, 1>;
  // Vectors of four lanes, where the instruction set has them.
  using FourFloats = std::conditional_t<hn::MaxLanes(Floats()) >= 4, hn::CappedTag<float, 4>, void>;
  using FourDoubles = std::conditional_t<hn::MaxLanes(Doubles()) >= 4, hn::CappedTag<double, 4>, void>;
  return {decide<Floats, Doubles>,
          decide<Doubles, Doubles>,
          decide<OneFloat, OneDouble>,
          decide<OneDouble, OneDouble>,
          decide_mesh<Floats, Doubles, FourFloats>,
          decide_mesh<Doubles, Doubles, FourDoubles>,
          decide_pair<FourFloats, OneFloat, OneDouble>,
          decide_pair<FourDoubles, OneDouble, OneDouble>};
}
}  // namespace axiscert::certified::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert::certified {
HWY_EXPORT(forms);

Forms chosen_forms() { return HWY_DYNAMIC_DISPATCH(forms)(); }
}  // namespace axiscert::certified
#endif
