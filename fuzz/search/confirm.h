// Exact evaluation, by all oracles, of a query that a search found: nothing is reported before that.
#pragma once

#include "exact/sphere_triangle/measures/error_measure.h"
#include "exact/sphere_triangle/claims/examine.h"
#include "exact/trait/examine.h"
#include "fuzz/search/goal.h"

namespace axiscert {

// The errors of the sixteen comparisons on one query, absolute and relative, both in u. Empty if a side is not finite
// or the exact sides are undefined; a relative error is also empty if |l| + |r| = 0 and l^ - r^ is not 0.
struct SideErrors {
  EnumArray<Comparison, std::optional<Decimal6>> absolute, relative;
};

// Asks one kernel. Keeps a reference to it.
template <class Real>
class Confirmer {
 public:
  Confirmer(const Kernel& kernel, std::string_view target)
      : kernel_(kernel),
        implementation_(kernel.on<Real>(target)),
        examiner_(kernel, target),
        oracle_examiner_(kernel, target) {}

  // The value of the aim on a query, rounded up to six digits: an error in u, a depth, ulps; for range, range_score().
  // Empty if the query shows none: not within the box of Goal::error, a side without scale or not finite, no wrong
  // verdict of that kind, a change of range that also occurs with unbounded exponents. Throws OracleDisagreement.
  std::optional<Decimal6> value(const Aim& aim, const Numbers<Real>& q);

  // Empty if the kernel exposes no computed sides of formulae of its own, or the query is not valid.
  std::optional<SideErrors> errors(const Query<Real>& q);

  // The full examination of a query of sphere-triangle.
  Examination examine(const Query<Real>& q) { return examiner_.examine(q); }
  // The links of the chain that are broken on the way to the verdict, for a query of any test.
  LinkSet verdict_links(const Numbers<Real>& q);

 private:
  std::optional<Decimal6> range(const Aim& aim, const Query<Real>& q);
  std::optional<Decimal6> depth(Goal goal, const Query<Real>& q);
  std::optional<Decimal6> depth_by_oracles(Goal goal, const Numbers<Real>& q);
  std::optional<Decimal6> critical_error(const Query<Real>& q);

  const Kernel& kernel_;
  Implementation<Real> implementation_;
  Examiner examiner_;
  OracleExaminer oracle_examiner_;  // of a test other than sphere-triangle
};

// |(l^ - r^) - (l - r)| / u, rounded up; if l is a root, from 256 bits of it.
template <class Real>
Decimal6 absolute_error(Real computed_lhs, Real computed_rhs, const ExactComparison& exact);

}  // namespace axiscert
