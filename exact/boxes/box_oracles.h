// The oracles of the test of two boxes, by entry.
#pragma once

#include "exact/trait/oracles.h"

namespace axiscert::boxes {

// For kernels that take the entry `matrix`, and for those that take `quaternion`.
const Oracles& matrix_oracles();
const Oracles& quaternion_oracles();

}  // namespace axiscert::boxes
