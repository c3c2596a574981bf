// One pair at a time: the sixteen comparisons in four compares of four lanes, as the article's last section suggests,
// and as a user writes them with Eigen.
#pragma once

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// Sides and bits of the published formulae, bit for bit. The side comparisons are `strict`, or `not_less`: where the
// only compare instruction is `>`, a >= b is computed as !(b > a), which is true where a side is NaN (an overflowed inf
// - inf). An edge whose radius comparison overflowed to inf > finite is then a separating axis although nothing is
// known about it: a missed contact.
template <Strictness strictness, class Real>
Implementation<Real> packed_implementation();

// The published test as a user writes it with Eigen.

// Uses Eigen::Vector3f or Vector3d with `.dot` and `.cross`. Eigen's reductions choose their own order of addition, so
// the sides may differ from the reference's in the last bits; the judge reports such differences as `implementation`.
template <class Real>
Implementation<Real> eigen_implementation();

}  // namespace axiscert
