// Kernels of two boxes over Highway's vectors, in the entry `matrix`: one query per lane, dispatched at run time.
// Sides, bits and verdicts are those of the scalar forms, bit for bit, on each instruction set.
#pragma once

#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert::boxes {

const LaneForms& simd_textbook();
const LaneForms& simd_cofactor();

}  // namespace axiscert::boxes
