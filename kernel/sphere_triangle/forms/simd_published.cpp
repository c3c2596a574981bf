// The published formulae on every instruction set.
#include <cstring>

#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/simd.h"

#define HWY_COMPILE_ALL_ATTAINABLE  // the narrow sets too: `--target` must reach each of them
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/sphere_triangle/forms/simd_published.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/sphere_triangle/formulae.h"
#include "kernel/sphere_triangle/forms/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
Implementation<float> published32(Strictness s) { return implementation<PublishedFormulae, float>(s); }
Implementation<double> published64(Strictness s) { return implementation<PublishedFormulae, double>(s); }
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
HWY_EXPORT(published32);
HWY_EXPORT(published64);

const SimdForms& simd_published() {
  static const SimdForms forms([](Strictness s) { return HWY_DYNAMIC_DISPATCH(published32)(s); },
                               [](Strictness s) { return HWY_DYNAMIC_DISPATCH(published64)(s); });
  return forms;
}
}  // namespace axiscert
#endif
