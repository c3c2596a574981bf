// Kernels of the moving sphere over Highway's vectors: one query per lane, dispatched at run time. Sides, bits and
// verdicts are those of the scalar forms, bit for bit, on each instruction set.
#pragma once

#include "kernel/sphere_triangle/forms/lane_forms.h"

namespace axiscert::moving_sphere {

const LaneForms& simd_twenty();
const LaneForms& simd_twenty_nonstrict();
const LaneForms& simd_rounded();  // verdicts alone

}  // namespace axiscert::moving_sphere
