// Kernels over Highway vectors: one query a lane, dispatched at run time. Sides and bits are those of the scalar
// reference, bit for bit, on each instruction set.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert {

// Highway's names of the instruction sets that were compiled and that this machine has, best first.
const std::vector<std::string>& simd_targets();

// One set of formulae on every instruction set.
class SimdForms {
 public:
  // The functions dispatch to the instruction set that Highway has chosen: they are asked under each in turn.
  SimdForms(Implementation<float> (*binary32)(Strictness), Implementation<double> (*binary64)(Strictness));
  // `target` is one of simd_targets(); strict or nonstrict.
  template <class Real>
  Implementation<Real> on(std::string_view target, Strictness strictness) const {
    const Forms& forms = by_target_.find(target)->second;
    if constexpr (sizeof(Real) == 4) return forms.binary32[static_cast<std::size_t>(strictness)];
    else return forms.binary64[static_cast<std::size_t>(strictness)];
  }

 private:
  struct Forms {
    Implementation<float> binary32[2];
    Implementation<double> binary64[2];
  };
  std::map<std::string, Forms, std::less<>> by_target_;
};

const SimdForms& simd_published();
const SimdForms& simd_reduced();

}  // namespace axiscert
