// Everything about one query and one kernel: what `check` prints and what a witness is made of.
#pragma once

#include "exact/claim.h"
#include "exact/error_measure.h"
#include "kernel/kernel.h"

namespace axiscert {

struct Examination {
  Truth truth;
  std::optional<Rational> squared_distance;  // exact; none where the truth is `invalid`
  Answer answer;
  Judgement judgement;
  std::optional<double> depth;  // of a wrong verdict
};

// Cross-checked by all oracles. Throws OracleDisagreement.
template <class Real>
Examination examine(const Query<Real>& q, const Kernel& kernel, std::string_view target);
// With the answer that the kernel gave earlier.
template <class Real>
Examination examine(const Query<Real>& q, const Kernel& kernel, const Answer& answer);

}  // namespace axiscert
