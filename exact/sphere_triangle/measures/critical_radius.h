// The critical radius: for fixed A, B, C, P the smallest radius for which a kernel says contact. `query.r` is not read.
#pragma once

#include <optional>
#include <vector>

#include "exact/numbers/decimal6.h"
#include "exact/sphere_triangle/measures/limits.h"
#include "exact/numbers/rational.h"
#include "kernel/kernel.h"

namespace axiscert {

template <class Real>
struct CriticalRadius {
  std::optional<Real> radius;  // nothing where the kernel does not say contact at the greatest radius of the range
  bool answered = true;        // false: a radius that was asked got no answer, and nothing was measured
  bool operator==(const CriticalRadius&) const = default;
};

// Found by bisection over the floats of a range, so a kernel whose answers are not monotone in r is measured at one of
// its changes. The range is not empty.
template <class Real>
CriticalRadius<Real> critical_radius(const Implementation<Real>& kernel, const Query<Real>& query,
                                     const RadiusRange<Real>& range = {});
// The same of each query, all of them in step: the kernel is asked as often as for one.
template <class Real>
std::vector<CriticalRadius<Real>> critical_radii(const Implementation<Real>& kernel,
                                                 const std::vector<Query<Real>>& queries,
                                                 const RadiusRange<Real>& range = {});

// The truth's: the least float that is not below the exact distance. Nothing where that is beyond the greatest.
template <class Real>
std::optional<Real> exact_critical_radius(const Rational& squared_distance);

// |radius - from| in ulps of d, the exact distance correctly rounded; rounded up to six digits.
template <class Real>
Decimal6 radius_error_ulps(Real radius, Real from, const Rational& squared_distance);

struct CriticalRadiusError {
  std::optional<double> ulps;  // infinity where there is no critical radius; nothing where none was sought or measured
  bool answered = true;        // as CriticalRadius has it
};

// The exact distance correctly rounded; nothing where that is beyond the precision or the range.
template <class Real>
std::optional<Real> distance_within(const Rational& squared_distance, const RadiusRange<Real>& range);

// The same from the distance already rounded, which is found without rationals for nearly every query: by the filters
// of exact/sphere_triangle/measures/nearest_root.h; where they are silent by integers; and only where the distance is a
// midpoint of two floats, or all but one, by the oracle's squared distance. Infinite beyond the precision.
template <class Real>
Real rounded_distance(const Query<Real>& query);
template <class Real>
std::optional<Real> rounded_distance_within(Real rounded_distance, const RadiusRange<Real>& range);

// |critical radius - d| in ulps of d, the exact distance correctly rounded. None is sought where d itself is beyond the
// precision or the range.
template <class Real>
CriticalRadiusError critical_radius_error(const CriticalRadius<Real>& critical, Real distance);
template <class Real>
CriticalRadiusError critical_radius_error(const Implementation<Real>& kernel, const Query<Real>& query,
                                          const Rational& squared_distance, const RadiusRange<Real>& range = {});

// Two radii that no monotone kernel has: the smaller sphere touches, the greater one is separated.
template <class Real>
struct RadiusReversal {
  Real contact, separated;  // contact < separated
  bool operator==(const RadiusReversal&) const = default;
};

// Asks the kernel at 0, the greatest finite radius, each power of two, and every float within 32 of `critical` and of
// `exact_radius`, where there are such. The first of these at which it says separated after contact, with the last
// contact before it; or nothing, which proves no monotonicity.
template <class Real>
std::optional<RadiusReversal<Real>> radius_reversal(const Implementation<Real>& kernel, const Query<Real>& query,
                                                    std::optional<Real> critical, std::optional<Real> exact_radius);

}  // namespace axiscert
