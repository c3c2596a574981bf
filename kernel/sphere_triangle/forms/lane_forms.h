// A kernel of any predicate over Highway's vectors: one query per lane, dispatched at run time, its answers those of
// the scalar form bit for bit on each instruction set.
#pragma once

#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert {

// One kernel on every instruction set; `target` is one of simd_targets().
class LaneForms {
 public:
  LaneForms(Implementation<float> (*binary32)(), Implementation<double> (*binary64)())
      : table_([&] {
          return Forms{binary32(), binary64()};
        }) {}
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

// The kernel, and in these forms on every target that is not scalar, with the scalar form's measures.
inline Kernel with_lane_forms(Kernel kernel, const LaneForms& (*forms)()) {
  if (simd_targets().empty()) return kernel;
  kernel.has_simd = true;
  const auto in_lanes = [=]<class Real>(const Implementation<Real>& scalar, std::string_view target) {
    if (target == scalar_target) return scalar;
    Implementation<Real> there = forms().on<Real>(target);
    there.measure = scalar.measure;
    return there;
  };
  kernel.binary32 = [=, scalar = kernel.binary32](std::string_view target) { return in_lanes(scalar(target), target); };
  kernel.binary64 = [=, scalar = kernel.binary64](std::string_view target) { return in_lanes(scalar(target), target); };
  return kernel;
}

}  // namespace axiscert
