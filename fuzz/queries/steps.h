// Steps from one float to the next.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace axiscert {

// x moved by `ulps` floats up or down; stops at +-infinity, and steps through zero to the other sign.
template <class Real>
Real step_ulps(Real x, int ulps) {
  const Real towards = ulps > 0 ? std::numeric_limits<Real>::infinity() : -std::numeric_limits<Real>::infinity();
  for (int i = std::abs(ulps); i > 0; --i) x = std::nextafter(x, towards);
  return x;
}

// The same for a radius, which stops at zero and at the greatest finite number.
template <class Real>
Real step_radius(Real r, int ulps) {
  return std::clamp(step_ulps(r, ulps), Real(0), std::numeric_limits<Real>::max());
}

}  // namespace axiscert
