// Floats that are moved: to the next ones, and, many at once, by a power of two.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <type_traits>

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

// Every number of a range times 2^exponent, as std::ldexp gives it: rounded once, if at all. Where 2^exponent is a
// normal number this is one product for each number, in vectors; ldexp is a call for each.
template <class Numbers>
void scale_by_power_of_two(Numbers& numbers, int exponent) {
  using Real = std::remove_cvref_t<decltype(*numbers.begin())>;
  using Limits = std::numeric_limits<Real>;
  if (exponent >= Limits::min_exponent - 1 && exponent < Limits::max_exponent) {
    const Real factor = std::ldexp(Real(1), exponent);
    for (Real& x : numbers) x *= factor;
  } else {
    for (Real& x : numbers) x = std::ldexp(x, exponent);
  }
}

}  // namespace axiscert
