// The twenty axes in the arithmetics of kernel/arithmetic/arithmetic_list.h: TWENTY+ARITHMETIC.
#pragma once

#include <string_view>

#include "kernel/kernel.h"

namespace axiscert::moving_sphere {

// The scalar form of `rung`, which is moving-sphere/twenty or moving-sphere/twenty-nonstrict, in that arithmetic. It
// claims the formulae, and not the bits of the plain reference: what differs from the exact formulae is unattributed.
Kernel twenty_in(std::string_view id, const Kernel& rung, const ArithmeticInfo& arithmetic);

}  // namespace axiscert::moving_sphere
