// The critical radius: for fixed A, B, C, P the smallest radius for which a kernel says contact.
#pragma once

#include <optional>

#include "exact/rational.h"
#include "kernel/kernel.h"

namespace axiscert {

// |critical radius - d| in ulps of d, the exact distance correctly rounded; found by bisection over the floats, so a
// kernel whose answers are not monotone in r is measured at one of its changes. Infinity where the kernel says contact
// for no finite radius; nothing where d itself is beyond the precision's range. `query.r` is not read.
template <class Real>
std::optional<double> critical_radius_error(const Implementation<Real>& kernel, const Query<Real>& query,
                                            const Rational& squared_distance);

}  // namespace axiscert
