// The published test as a user writes it with Eigen.
#pragma once

#include "kernel/kernel.h"

namespace axiscert {

// Eigen::Vector3f or Vector3d, `.dot` and `.cross`: its reductions choose their own order of addition, so that sides
// may differ from the reference's in the last bits. The judge shows where as `implementation`.
template <class Real>
Implementation<Real> eigen_implementation();

}  // namespace axiscert
