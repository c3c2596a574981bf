// The engines' form on every instruction set: every piece in every lane, and the least time.
#include "kernel/kernel.h"
#include "kernel/moving_sphere/kernels.h"
#include "kernel/formulae_kernel.h"

#define HWY_COMPILE_ALL_ATTAINABLE  // the narrow sets too: `--target` must reach each of them
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/moving_sphere/simd_rounded.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/moving_sphere/rounded.h"
#include "kernel/moving_sphere/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
Implementation<float> rounded32() { return {first_hit_verdicts<RoundedDifference, float>}; }
Implementation<double> rounded64() { return {first_hit_verdicts<RoundedDifference, double>}; }
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
HWY_EXPORT(rounded32);
HWY_EXPORT(rounded64);

const LaneForms& moving_sphere::simd_rounded() {
  static const LaneForms forms([] { return HWY_DYNAMIC_DISPATCH(rounded32)(); },
                               [] { return HWY_DYNAMIC_DISPATCH(rounded64)(); });
  return forms;
}
}  // namespace axiscert
#endif
