// Kernels of the moving sphere over Highway's vectors: one query per lane, dispatched at run time. Sides, bits and
// verdicts are those of the scalar forms, bit for bit, on each instruction set.
#pragma once

#include <string_view>

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert::moving_sphere {
const LaneForms& simd_twenty();
const LaneForms& simd_twenty_nonstrict();
const LaneForms& simd_rounded();  // verdicts alone

// The twenty axes in the arithmetics of kernel/base/arithmetic_list.h: TWENTY+ARITHMETIC.

// The scalar form of `rung`, which is moving-sphere/twenty or moving-sphere/twenty-nonstrict, in that arithmetic. It
// claims the formulae, and not the bits of the plain reference: what differs from the exact formulae is unattributed.
Kernel twenty_in(std::string_view id, const Kernel& rung, const ArithmeticInfo& arithmetic);

}  // namespace axiscert::moving_sphere
