// The values that kernels claim to compute on one query, level by level of the chain.
#pragma once

#include <deque>

#include "exact/judge/judge.h"
#include "exact/sphere_triangle/oracles/formula_oracle.h"
#include "kernel/kernel.h"

namespace axiscert {

// The claims of several kernels on one valid query. Results that kernels share are evaluated once. Keeps references to
// its arguments.
template <class Real>
class Claims {
 public:
  // `by_mpfr`: R-infinity is computed by MPFR on every query.
  Claims(const Query<Real>& q, const FormulaTruth& published, bool by_mpfr = false)
      : query_(q), published_(published), by_mpfr_(by_mpfr) {}

  // The exact sides of a set of formulae; null for `none` and for a method, which has no sides. Throws
  // OracleDisagreement if a rung defines a sign that differs from the published one: over the reals no query can cause
  // that.
  const FormulaTruth* sides(Formulae formulae);
  // The chain for a kernel's claim; empty if the kernel claims no formulae.
  std::optional<Reference> chain(const Kernel& kernel);

 private:
  const Query<Real>& query_;
  const FormulaTruth& published_;
  bool by_mpfr_;
  std::deque<std::pair<Formulae, FormulaTruth>> others_;
};

}  // namespace axiscert
