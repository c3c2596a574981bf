// The limits within which a kernel promises to be right, decided exactly.
#pragma once

#include <limits>

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Whether a valid query lies within limits, which must be finite and not negative. A query exactly on a limit is
// within.
template <class Real>
bool is_within(const Limits& limits, const Query<Real>& q);

template <class Real>
struct RadiusRange {
  Real least = 0, greatest = std::numeric_limits<Real>::max();
  bool operator==(const RadiusRange&) const = default;
};
// The radii within limits: the least and the greatest such number of the precision. An empty range, least > greatest,
// if no number of the precision is within.
template <class Real>
RadiusRange<Real> radii_within(const Limits& limits);

}  // namespace axiscert
