// Formula truth E: a kernel's own formulae in exact arithmetic.
#pragma once

#include <vector>

#include "exact/numbers/rational.h"
#include "exact/numbers/surd.h"
#include "kernel/sphere_triangle/reference/evaluate.h"
#include "kernel/formulae_list.h"

namespace axiscert {

Rational rational(const Ring& x);

// The exact sides of one comparison: lhs / denominator, or sqrt(lhs) / denominator if rooted, and rhs / denominator.
struct ExactComparison {
  const Ring &lhs, &rhs, &denominator;
  bool rooted, undefined;
};

struct FormulaTruth {
  Sides<Ring> sides;       // exact if the formulae are a ring; otherwise read them through comparison()
  SignBits strict, ties;   // lhs > rhs; lhs == rhs
  SignBits undefined = 0;  // 0/0 in exact arithmetic: the comparison does not hold and has no sides
  SignBits rooted = 0;
  std::vector<Ring> denominators{};  // positive; empty: all 1

  SignBits bits(Strictness strictness) const {
    return strictness == Strictness::strict ? strict : static_cast<SignBits>(strict | (ties & side_comparisons));
  }
  ExactComparison comparison(std::size_t i) const;
};

// The sides of a valid query (finite, r >= 0). Requires that `formulae` have comparisons.
template <class Real>
FormulaTruth formula_truth(Formulae formulae, const Query<Real>& q);

// The sides of the published formulae.
template <class Real>
FormulaTruth formula_truth(const Query<Real>& q) {
  return formula_truth(Formulae::published, q);
}
// The published sides of a problem that is already centred, for code that solves on a boundary or scales a lattice.
FormulaTruth formula_truth(const portable::Centred<Ring>& centred);

// The verdict of a method, which has no comparisons.
template <class Real>
Verdict exact_verdict(Formulae method, const Query<Real>& q);

}  // namespace axiscert
