// A number type in which x y + z is fused wherever a compiler that contracts could fuse it: what -ffp-contract=off is
// there to prevent. For planting that fault in tests.
#pragma once

#include <cmath>

namespace axiscert {

// A value, or a product still waiting to be rounded: an addition that meets it fuses the two.
template <class Real>
struct Contracted {
  Real value = 0, factor = 1;

  Real rounded() const { return value * factor; }
  friend Contracted operator*(Contracted a, Contracted b) { return {a.rounded(), b.rounded()}; }
  friend Contracted operator+(Contracted a, Contracted b) { return {std::fma(b.value, b.factor, a.rounded())}; }
  friend Contracted operator-(Contracted a, Contracted b) { return {std::fma(-b.value, b.factor, a.rounded())}; }
};

}  // namespace axiscert
