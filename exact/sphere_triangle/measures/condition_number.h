// The condition of a comparison on one query: whether the question or the formula is to blame for a wrong answer.
#pragma once

#include "exact/numbers/rational.h"
#include "kernel/formulae_list.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// kappa = sum |x_i dm/dx_i| / |m| over the query's thirteen numbers x_i, with m = lhs - rhs of the exact formulae. To
// first order, changing each number by the relative amount u changes m by kappa u |m| at most: if kappa u >= 1, the
// rounding of the input alone may change the sign, and no formula of that precision can be blamed. m is homogeneous in
// the query, so that kappa is never less than m's degree (Euler).
struct Condition {
  enum class Kind : std::uint8_t {
    finite,
    infinite,     // m = 0: ill-conditioned by definition
    undefined,    // 0/0 in exact arithmetic: m does not exist
    not_decided,  // m has no derivative here: the root of a distance that is 0
  };
  Kind kind = Kind::not_decided;
  bool ill_conditioned = false;  // kappa u >= 1, decided exactly
  // The product kappa u of Kind::finite, to six digits: rounded up from the exact value, or, if a root occurs in it,
  // from 128 bits of it.
  Decimal6 kappa_u;
};

// The conditions of the comparisons in `wanted`; the others are left at `not_decided`. Requires that `formulae` have
// comparisons and that q is valid; u is that of Real.
template <class Real>
EnumArray<Comparison, Condition> conditions(Formulae formulae, const Query<Real>& q, ComparisonBits wanted);

}  // namespace axiscert
