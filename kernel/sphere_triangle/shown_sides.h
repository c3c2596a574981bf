// The sides that a kernel of sphere-triangle shows, out of its answer to a batch.
#pragma once

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/decision.h"

namespace axiscert {

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
