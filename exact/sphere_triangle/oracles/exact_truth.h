// The truth about one query, and the cross-checks that every query has to pass before anything is reported.
#pragma once

#include <optional>

#include "exact/judge/truth.h"
#include "exact/sphere_triangle/oracles/formula_oracle.h"

namespace axiscert {

// The truth with the exact sides against which it was checked; without them if the verdict is `invalid`.
struct ExactTruth : Truth {
  std::optional<ExactSides> sides;  // of the published formulae
};

// Decides by CGAL and by the exact formulae and compares: the verdict of the formulae with non-strict sides is the
// geometric one on every triangle; with strict sides it may differ only on a zero-area triangle, and only as a phantom
// contact. With `second_opinion`, and before any disagreement is reported, MPFR repeats all decisions. Throws
// OracleDisagreement.
template <class Real>
ExactTruth exact_truth(const Query<Real>& q, bool second_opinion);

}  // namespace axiscert
