// The published test as a user writes it with Eigen.
#pragma once

#include "kernel/kernel.h"

namespace axiscert {

// Uses Eigen::Vector3f or Vector3d with `.dot` and `.cross`. Eigen's reductions choose their own order of addition, so
// the sides may differ from the reference's in the last bits; the judge reports such differences as `implementation`.
template <class Real>
Implementation<Real> eigen_implementation();

}  // namespace axiscert
