// What a query that a search came up with really shows, by exact arithmetic and all oracles: nothing is reported
// before.
#pragma once

#include "exact/sphere_triangle/measures/error_measure.h"
#include "exact/judge/examine.h"
#include "fuzz/search/goal.h"

namespace axiscert {

// The errors of the sixteen comparisons on one query, absolute and relative, both in u. Nothing where a side is not
// finite or the exact sides are undefined; of the relative ones also where |l| + |r| = 0 and l^ - r^ is not.
struct SideErrors {
  std::array<std::optional<Decimal6>, comparison_count> absolute, relative;
};

// Asks one kernel. Borrows it.
template <class Real>
class Confirmer {
 public:
  Confirmer(const Kernel& kernel, std::string_view target)
      : kernel_(kernel), implementation_(kernel.on<Real>(target)), examiner_(kernel, target) {}

  // How much the query shows of what is looked for, rounded up to six digits: an error in u, a depth, ulps; of range,
  // range_score(). Nothing where it shows nothing of it: not within the box of Goal::error, a side without scale or not
  // finite, no wrong verdict of that kind, a change of range that unbounded exponents share. Throws OracleDisagreement.
  std::optional<Decimal6> value(const Aim& aim, const Query<Real>& q);

  // Nothing where the kernel shows no computed sides of formulae of its own, or the query is not valid.
  std::optional<SideErrors> errors(const Query<Real>& q);

  // All there is to say of it.
  Examination examine(const Query<Real>& q) { return examiner_.examine(q); }

 private:
  std::optional<Decimal6> range(const Aim& aim, const Query<Real>& q);
  std::optional<Decimal6> depth(Goal goal, const Query<Real>& q);
  std::optional<Decimal6> critical_error(const Query<Real>& q);

  const Kernel& kernel_;
  Implementation<Real> implementation_;
  Examiner examiner_;
};

// |(l^ - r^) - (l - r)| / u, rounded up; where l is a root, from 256 bits of it.
template <class Real>
Decimal6 absolute_error(Real computed_lhs, Real computed_rhs, const ExactComparison& exact);

}  // namespace axiscert
