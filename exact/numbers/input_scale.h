// Sizes in the input of a query beyond which a formula in its precision may be wrong for that reason alone.
#pragma once

#include <limits>

namespace axiscert {

// Lengths for which a formula of degree 6 keeps to the normal numbers. The greatest value that the published formulae
// form is below 2592 L^6 < 2^11.4 L^6 (the side comparison of an edge), which is finite for L <= `greatest`. A side of
// the size of `least`^6 has its last bit at u least^6, which is normal. The square of `least_radius` is the least
// normal number.
template <class Real>
struct ScaleWindow {
  using Limits = std::numeric_limits<Real>;
  static constexpr int greatest_exponent = (Limits::max_exponent - 12) / 6;
  static constexpr int least_exponent = (Limits::min_exponent - 1 + Limits::digits) / 6;
  static constexpr int least_radius_exponent = (Limits::min_exponent - 1) / 2;
};
static_assert(ScaleWindow<float>::greatest_exponent == 19 && ScaleWindow<float>::least_exponent == -17 &&
              ScaleWindow<float>::least_radius_exponent == -63);
static_assert(ScaleWindow<double>::greatest_exponent == 168 && ScaleWindow<double>::least_exponent == -161 &&
              ScaleWindow<double>::least_radius_exponent == -511);

// 64 u: 2^-18 or 2^-47.
template <class Real>
inline constexpr double near_tie_depth = 32 * double(std::numeric_limits<Real>::epsilon());

// The greatest coordinate over L, the greatest number as seen from the query itself.
inline constexpr double far_from_origin = 64;

}  // namespace axiscert
