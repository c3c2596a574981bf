// The truth about one query, and the cross-checks that every query passes before anything is reported.
#pragma once

#include <optional>

#include "exact/formula_oracle.h"
#include "kernel/error.h"

namespace axiscert {

struct Truth {
  Verdict verdict;                      // separated, contact (touching included) or invalid
  bool touching;                        // distance exactly r
  std::optional<FormulaTruth> formula;  // none where the verdict is `invalid`
};

// Two oracles differ, or one contradicts the theorem. Carries the query for saving (a float widens exactly).
struct OracleDisagreement : HarnessFault {
  template <class Real>
  OracleDisagreement(const std::string& what, const Query<Real>& q)
      : HarnessFault("the oracles disagree: " + what), precision(precision_of<Real>), query(coordinates(widened(q))) {}
  Precision precision;
  std::array<double, coordinate_count> query;
};

// Decides by CGAL and by the exact formulae and compares: the verdict of the formulae with non-strict sides is the
// geometric one on every triangle; with strict sides it may differ on a zero-area triangle only, and only as a phantom
// contact. With `second_opinion`, and before any disagreement is reported, MPFR decides all of it again.
// Throws OracleDisagreement.
template <class Real>
Truth exact_truth(const Query<Real>& q, bool second_opinion);

}  // namespace axiscert
