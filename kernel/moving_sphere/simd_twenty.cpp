// The twenty axes on every instruction set.
#include "kernel/kernel.h"
#include "kernel/moving_sphere/kernels.h"
#include "kernel/formulae_kernel.h"

#define HWY_COMPILE_ALL_ATTAINABLE  // the narrow sets too: `--target` must reach each of them
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel/moving_sphere/simd_twenty.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/moving_sphere/twenty.h"
#include "kernel/moving_sphere/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
Implementation<float> twenty32() { return motion_implementation<Twenty, float>(); }
Implementation<double> twenty64() { return motion_implementation<Twenty, double>(); }
Implementation<float> twenty_nonstrict32() { return motion_implementation<TwentyNonstrict, float>(); }
Implementation<double> twenty_nonstrict64() { return motion_implementation<TwentyNonstrict, double>(); }
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
HWY_EXPORT(twenty32);
HWY_EXPORT(twenty64);
HWY_EXPORT(twenty_nonstrict32);
HWY_EXPORT(twenty_nonstrict64);

namespace moving_sphere {

const LaneForms& simd_twenty() {
  static const LaneForms forms([] { return HWY_DYNAMIC_DISPATCH(twenty32)(); },
                               [] { return HWY_DYNAMIC_DISPATCH(twenty64)(); });
  return forms;
}
const LaneForms& simd_twenty_nonstrict() {
  static const LaneForms forms([] { return HWY_DYNAMIC_DISPATCH(twenty_nonstrict32)(); },
                               [] { return HWY_DYNAMIC_DISPATCH(twenty_nonstrict64)(); });
  return forms;
}

}  // namespace moving_sphere
}  // namespace axiscert
#endif
