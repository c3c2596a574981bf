// Formula truth E: a kernel's own formulae in exact arithmetic.
#pragma once

#include "exact/trait/exact_sides.h"
#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/reference/evaluate.h"

namespace axiscert {

// The sides of a valid query (finite, r >= 0). Requires that `formulae` have comparisons.
template <class Real>
ExactSides exact_sides(Formulae formulae, const Query<Real>& q);

// The sides of the published formulae.
template <class Real>
ExactSides exact_sides(const Query<Real>& q) {
  return exact_sides(Formulae::published, q);
}
// The published sides of a problem that is already centred, for code that solves on a boundary or scales a lattice.
ExactSides exact_sides(const portable::CentredProblem<BinaryNumber>& centred);

// The verdict of a method, which has no comparisons.
template <class Real>
Verdict exact_verdict(Formulae method, const Query<Real>& q);

}  // namespace axiscert
