// The scalar reference: it defines the meaning of a kernel, to the bit, in the precision of the input.
#pragma once

#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/reference/evaluate.h"
#include "kernel/kernel.h"

namespace axiscert {

// The outcome of `formulae` on q in `arithmetic`, evaluated one operation after the other. Also writes the computed
// sides if `sides` is not null and the formulae have comparisons. `plain` means round to nearest even, gradual
// underflow, one rounding per operation and no contraction. An arithmetic other than plain exists for rungs only, in
// the precisions that arithmetics() says.
template <class Real>
Outcome reference(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q,
                  Sides<Real>* sides = nullptr) noexcept;

// The sides of the published formulae in plain arithmetic.
Sides<float> reference_sides(const Query<float>& q) noexcept;
Sides<double> reference_sides(const Query<double>& q) noexcept;

}  // namespace axiscert
