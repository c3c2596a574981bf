// Formula truth E: the kernel's own formulae in exact ring arithmetic.
#pragma once

#include <CGAL/Mpzf.h>

#include "exact/rational.h"
#include "kernel/evaluate.h"

namespace axiscert {

// Exact over the whole range of binary64, subnormals included. A ring: it has no division.
using Ring = CGAL::Mpzf;

Rational rational(const Ring& x);

struct FormulaTruth {
  Sides<Ring> sides;            // exact
  ComparisonBits strict, ties;  // lhs > rhs; lhs == rhs
  ComparisonBits bits(Strictness strictness) const {
    return strictness == Strictness::strict ? strict : static_cast<ComparisonBits>(strict | (ties & side_comparisons));
  }
};

// For every valid query (finite, r >= 0).
template <class Real>
FormulaTruth formula_truth(const Query<Real>& q);

// The published sides of a problem already centred, for the places that solve on a boundary or scale a lattice.
FormulaTruth formula_truth(const portable::Centred<Ring>& centred);

}  // namespace axiscert
