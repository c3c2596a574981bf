// Numbers times a power of two, many at once.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace axiscert {

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
