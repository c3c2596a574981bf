// The critical radius of a sphere beside a triangle, and its error, for which `query.r` is not read; and the limits
// within which a kernel promises to be right.
#pragma once

#include <optional>
#include <vector>

#include "exact/judge/critical_radius.h"
#include "exact/numbers/rational.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// Whether a valid query lies within limits, decided exactly; they must be finite and not negative. A query exactly on a
// limit is within.
template <class Real>
bool is_within(const Limits& limits, const Query<Real>& q);

// Those of exact/judge/critical_radius.h, of a query with its members.
template <class Real>
CriticalRadius<Real> critical_radius(const Implementation<Real>& kernel, const Query<Real>& query,
                                     const RadiusRange<Real>& range = {});
template <class Real>
std::vector<CriticalRadius<Real>> critical_radii(const Implementation<Real>& kernel,
                                                 const std::vector<Query<Real>>& queries,
                                                 const RadiusRange<Real>& range = {});

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

}  // namespace axiscert
