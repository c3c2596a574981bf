// The reduced formulae on every instruction set.
#include <cstring>

#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/simd.h"

#define HWY_COMPILE_ALL_ATTAINABLE  // the narrow sets too: `--target` must reach each of them
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/sphere_triangle/forms/simd_reduced.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/sphere_triangle/forms/reduced.h"
#include "kernel/sphere_triangle/forms/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
Implementation<float> reduced32(Strictness s) { return implementation<ReducedFormulae, float>(s); }
Implementation<double> reduced64(Strictness s) { return implementation<ReducedFormulae, double>(s); }
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
HWY_EXPORT(reduced32);
HWY_EXPORT(reduced64);

const SimdForms& simd_reduced() {
  static const SimdForms forms([](Strictness s) { return HWY_DYNAMIC_DISPATCH(reduced32)(s); },
                               [](Strictness s) { return HWY_DYNAMIC_DISPATCH(reduced64)(s); });
  return forms;
}
}  // namespace axiscert
#endif
