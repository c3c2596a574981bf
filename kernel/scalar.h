// The scalar reference: the meaning of a kernel, to the bit, in the precision of its input.
#pragma once

#include "kernel/evaluate.h"
#include "kernel/kernel.h"

namespace axiscert {

// Computed sides in Real: round to nearest even, gradual underflow, one rounding an operation, nothing contracted.
Sides<float> reference_sides(const Query<float>& q) noexcept;
Sides<double> reference_sides(const Query<double>& q) noexcept;

// The reference as a batch kernel.
template <class Real>
Implementation<Real> scalar_implementation(Strictness strictness);

}  // namespace axiscert
