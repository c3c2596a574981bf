// What the kernels claim to compute, on one query, level by level of the chain.
#pragma once

#include <deque>

#include "exact/judge/judge.h"
#include "exact/sphere_triangle/oracles/formula_oracle.h"
#include "kernel/kernel.h"

namespace axiscert {

// The claims of several kernels on one valid query; what kernels share is evaluated once. Borrows its arguments.
template <class Real>
class Claims {
 public:
  // `by_mpfr`: R-infinity by MPFR on every query.
  Claims(const Query<Real>& q, const FormulaTruth& published, bool by_mpfr = false)
      : query_(q), published_(published), by_mpfr_(by_mpfr) {}

  // The exact sides of a set of formulae; null for `none` and for a method, which has none. A rung whose signs differ
  // from the published ones, where it defines them, throws OracleDisagreement: over the reals there is no such query.
  const FormulaTruth* sides(Formulae formulae);
  // The chain of a kernel's claim; nothing where it claims no formulae.
  std::optional<Reference> chain(const Kernel& kernel);

 private:
  const Query<Real>& query_;
  const FormulaTruth& published_;
  bool by_mpfr_;
  std::deque<std::pair<Formulae, FormulaTruth>> others_;
};

}  // namespace axiscert
