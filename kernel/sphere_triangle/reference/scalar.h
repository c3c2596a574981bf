// The scalar reference: the meaning of a kernel, to the bit, in the precision of its input.
#pragma once

#include "kernel/sphere_triangle/reference/evaluate.h"
#include "kernel/kernel.h"

namespace axiscert {

// What `formulae` decide on q in `arithmetic`, one operation after the other; the computed sides where `sides` is given
// and the formulae have comparisons. `plain`: round to nearest even, gradual underflow, one rounding an operation,
// nothing contracted. An arithmetic other than plain exists for rungs only, in the precisions that arithmetics() says.
template <class Real>
Outcome reference(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q,
                  Sides<Real>* sides = nullptr) noexcept;

// Of the published formulae.
Sides<float> reference_sides(const Query<float>& q) noexcept;
Sides<double> reference_sides(const Query<double>& q) noexcept;

}  // namespace axiscert
