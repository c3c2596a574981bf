// Kernels of the moving sphere over Highway's vectors: one query per lane, dispatched at run time. Sides, bits and
// verdicts are those of the scalar forms, bit for bit, on each instruction set.
#pragma once

#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert::moving_sphere {

// One kernel on every instruction set; `target` is one of simd_targets().
class MotionSimd {
 public:
  MotionSimd(Implementation<float> (*binary32)(), Implementation<double> (*binary64)());
  template <class Real>
  Implementation<Real> on(std::string_view target) const {
    if constexpr (sizeof(Real) == 4) return table_.on(target).binary32;
    else return table_.on(target).binary64;
  }

 private:
  struct Forms {
    Implementation<float> binary32;
    Implementation<double> binary64;
  };
  SimdTable<Forms> table_;
};

const MotionSimd& simd_twenty();
const MotionSimd& simd_twenty_nonstrict();
const MotionSimd& simd_rounded();  // verdicts alone

}  // namespace axiscert::moving_sphere
