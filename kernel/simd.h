// The published formulae over Highway vectors: one query a lane, dispatched at run time.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert {

// Highway's names of the instruction sets that were compiled and that this machine has, best first.
std::vector<std::string> simd_targets();

// `target` is one of simd_targets(). Sides and bits are those of the scalar reference, bit for bit, on each.
template <class Real>
Implementation<Real> simd_implementation(Strictness strictness, std::string_view target);

}  // namespace axiscert
