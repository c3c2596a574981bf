// The critical radius: the least value of one length of a query, all else as it is, for which a kernel says contact. It
// is found by asking, and is that of a sphere or the half extent of a box (CriticalLength of exact/judge/oracles.h).
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "exact/numbers/rational.h"
#include "kernel/kernel.h"

namespace axiscert {

template <class Real>
struct RadiusRange {
  Real least = 0, greatest = std::numeric_limits<Real>::max();
  bool operator==(const RadiusRange&) const = default;
};
// The radii within limits: the least and the greatest such number of the precision. An empty range, least > greatest,
// if no number of the precision is within.
template <class Real>
RadiusRange<Real> radii_within(const Limits& limits);

// A query of any predicate; the number of one column is not read.
template <class Real>
struct QueryWithRadius {
  Numbers<Real> numbers;
  std::size_t column;
};

template <class Real>
struct CriticalRadius {
  std::optional<Real> radius;  // empty if the kernel does not say contact at the greatest radius of the range
  bool answered = true;        // false: the kernel did not answer at some radius, and nothing was measured
  // `undecided` or `invalid`, the first of these that it said at some radius: the change that was found may be one to
  // that, and not from separated to contact.
  std::optional<Verdict> not_decided = {};
  bool operator==(const CriticalRadius&) const = default;
};

// Bisects over the floats of a range, so for a kernel whose answers are not monotone in r it finds one of the changes.
// The range must not be empty.
template <class Real>
CriticalRadius<Real> critical_radius(const Implementation<Real>& kernel, const QueryWithRadius<Real>& query,
                                     const RadiusRange<Real>& range = {});
// The same for each query, all in step: the number of calls of the kernel is that for one query.
template <class Real>
std::vector<CriticalRadius<Real>> critical_radii(const Implementation<Real>& kernel,
                                                 const std::vector<QueryWithRadius<Real>>& queries,
                                                 const RadiusRange<Real>& range = {});

// |radius - from| in ulps of d, the exact distance correctly rounded; rounded up to six decimal digits.
template <class Real>
Decimal6 radius_error_ulps(Real radius, Real from, const Rational& squared_distance);

// The distance between a number and the next greater one; of the greatest, the one before.
template <class Real>
Real ulp_of(Real x);

// Two radii that contradict monotonicity: the smaller sphere touches, the greater one is separated.
template <class Real>
struct RadiusReversal {
  Real contact, separated;  // contact < separated
  bool operator==(const RadiusReversal&) const = default;
};

// Asks the kernel at 0, the greatest finite radius, each power of two, and every float within 32 of `critical` and of
// `exact_radius`, if they exist. Returns the first of these at which it says separated after contact, with the last
// contact before it. An empty result does not prove monotonicity.
template <class Real>
std::optional<RadiusReversal<Real>> radius_reversal(const Implementation<Real>& kernel,
                                                    const QueryWithRadius<Real>& query, std::optional<Real> critical,
                                                    std::optional<Real> exact_radius);

}  // namespace axiscert
