// Code shared by the tests of query files.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Expects the same thirteen numbers, with signed zeros distinguished; a NaN equals a NaN.
template <class Real>
void expect_same_bits(const Query<Real>& x, const Query<Real>& y) {
  const auto u = coordinates(x), v = coordinates(y);
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    if (std::isnan(u[k])) {
      EXPECT_TRUE(std::isnan(v[k]));
    } else {
      EXPECT_TRUE(u[k] == v[k] && std::signbit(u[k]) == std::signbit(v[k])) << coordinate_names[k] << " " << u[k];
    }
  }
}

}  // namespace axiscert
