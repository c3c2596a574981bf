// The scalar reference: it defines the meaning of a kernel, to the bit, in the precision of the input.
#pragma once

#include "kernel/formulae_list.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/query.h"

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

// The sides that a kernel of sphere-triangle shows, out of its answer to a batch.

// The computed sides of one query of the batch.
template <class Real>
Sides<Real> sides_at(const Answers<Real>& answers, std::size_t query) {
  Sides<Real> sides;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    sides.lhs[k] = answers.lhs[k][query];
    sides.rhs[k] = answers.rhs[k][query];
  }
  return sides;
}

}  // namespace axiscert
