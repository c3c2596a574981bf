// The critical radius: for fixed A, B, C, P the smallest radius for which a kernel says contact. `query.r` is not read.
#pragma once

#include <optional>
#include <vector>

#include "exact/numbers/decimal6.h"
#include "exact/sphere_triangle/measures/limits.h"
#include "exact/numbers/rational.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

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
CriticalRadius<Real> critical_radius(const Implementation<Real>& kernel, const Query<Real>& query,
                                     const RadiusRange<Real>& range = {});
// The same for each query, all in step: the number of calls of the kernel is that for one query.
template <class Real>
std::vector<CriticalRadius<Real>> critical_radii(const Implementation<Real>& kernel,
                                                 const std::vector<Query<Real>>& queries,
                                                 const RadiusRange<Real>& range = {});

// A query of any test, whose radius is the number of one column.
template <class Real>
struct QueryWithRadius {
  Numbers<Real> numbers;
  std::size_t column;
};
// The same for such a query.
template <class Real>
CriticalRadius<Real> critical_radius(const Implementation<Real>& kernel, const QueryWithRadius<Real>& query,
                                     const RadiusRange<Real>& range = {});

// The true critical radius: the least float that is not below the exact distance. Empty if that is beyond the greatest
// float.
template <class Real>
std::optional<Real> exact_critical_radius(const Rational& squared_distance);

// |radius - from| in ulps of d, the exact distance correctly rounded; rounded up to six decimal digits.
template <class Real>
Decimal6 radius_error_ulps(Real radius, Real from, const Rational& squared_distance);

struct CriticalRadiusError {
  std::optional<double> ulps;  // infinity if there is no critical radius; empty if none was sought or measured
  bool answered = true;        // as in CriticalRadius
  std::optional<Verdict> not_decided = {};  // as in CriticalRadius: then none was measured
};

// The exact distance correctly rounded; empty if that is beyond the precision or the range.
template <class Real>
std::optional<Real> distance_within(const Rational& squared_distance, const RadiusRange<Real>& range);

// The correctly rounded distance, infinite beyond the precision. For nearly every query it is found without rationals:
// by the filters of exact/sphere_triangle/measures/nearest_root.h; if they do not decide, by integers; and only if the
// distance is, or is extremely close to, a midpoint of two floats, by the oracle's squared distance.
template <class Real>
Real rounded_distance(const Query<Real>& query);
template <class Real>
std::optional<Real> rounded_distance_within(Real rounded_distance, const RadiusRange<Real>& range);

// |critical radius - d| in ulps of d, the exact distance correctly rounded. No error is computed if d itself is beyond
// the precision or the range.
template <class Real>
CriticalRadiusError critical_radius_error(const CriticalRadius<Real>& critical, Real distance);
template <class Real>
CriticalRadiusError critical_radius_error(const Implementation<Real>& kernel, const Query<Real>& query,
                                          const Rational& squared_distance, const RadiusRange<Real>& range = {});

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
std::optional<RadiusReversal<Real>> radius_reversal(const Implementation<Real>& kernel, const Query<Real>& query,
                                                    std::optional<Real> critical, std::optional<Real> exact_radius);

template <class Real>
std::optional<RadiusReversal<Real>> radius_reversal(const Implementation<Real>& kernel,
                                                    const QueryWithRadius<Real>& query, std::optional<Real> critical,
                                                    std::optional<Real> exact_radius);

}  // namespace axiscert
