// The limits within which a kernel promises to be right, decided exactly.
#pragma once

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Whether a valid query lies within limits, which must be finite and not negative. A query exactly on a limit is
// within.
template <class Real>
bool is_within(const Limits& limits, const Query<Real>& q);

}  // namespace axiscert
