// The rotation and the place of a box as FCL takes them.
#pragma once

#include <fcl/fcl.h>

#include "kernel/peers/boxes/box_pair.h"

namespace axiscert::peer {

inline fcl::Vector3<double> fcl_vector(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

inline fcl::Matrix3<double> fcl_rotation(const Box<double>& box) {
  fcl::Matrix3<double> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      rows(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = row(box, i, k);
  }
  return rows;
}

}  // namespace axiscert::peer
