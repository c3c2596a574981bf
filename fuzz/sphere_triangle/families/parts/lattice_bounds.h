// Integers on which the published formulae never round, and the powers of two times which they stay in range.
#pragma once

#include <cstdint>
#include <limits>

#include "fuzz/queries/image_groups.h"

namespace axiscert {

// Coordinates in [-m, m], radii that are halves up to `radius_in_halves` / 2. Let D = 2m bound the coordinates of every
// difference of two points, so that its length is at most sqrt(3) D. With h <= sqrt(3) D the distance from P to a line:
//   e1 = |AB|^2 <= 3 D^2,  |d1| <= 3 D^2,  |V|^2 = e <= |AB|^2 |AC|^2 <= 9 D^4,  |A . V| <= sqrt(3)^3 D^3
//   |Q1| = e1 h <= sqrt(27) D^3,  |QC| <= |C| e1 + |Q1| <= 2 sqrt(27) D^3
//   the partial sums of Q1 . QC: at most |Q1| |QC| <= 54 D^6; of Q1 . Q1 and d d: at most 27 D^6
//   four times rr e and rr e1 e1 (an integer, r being a half): at most (2r)^2 9 D^4
// All are integers, exact below 2^digits.
template <class Real>
struct LatticeBounds {
  static constexpr std::int64_t m = sizeof(Real) == 4 ? 4 : 117;
  static constexpr std::int64_t radius_in_halves = sizeof(Real) == 4 ? 21 : 577;
};
template <class Real>
constexpr bool exact_within_bounds() {
  using Bounds = LatticeBounds<Real>;
  constexpr std::int64_t limit = std::int64_t{1} << std::numeric_limits<Real>::digits;
  constexpr std::int64_t d2 = 4 * Bounds::m * Bounds::m, h = Bounds::radius_in_halves;
  return 54 * d2 * d2 * d2 <= limit && h * h * 9 * d2 * d2 <= limit;
}
static_assert(exact_within_bounds<float>() && exact_within_bounds<double>());

// The powers of two by which coordinates that are integers in [-m, m] and a radius of halves, at most 4 m, may be
// multiplied: 54 D^6 = 3456 m^6, which then bounds every form of degree 6 above, stays finite; and a quarter, the least
// that one can be other than zero, stays normal. The same holds for every polynomial of degree 6 or less in the
// differences that is bounded in this way, in any order of operations: nothing of it overflows or underflows, so that
// each rounding at one power of two is that at every other.
template <class Real>
constexpr PowerRange range_of_degree_6(std::int64_t m) {
  using Limits = std::numeric_limits<Real>;
  int bits = 0;
  for (double bound = 3456.0 * static_cast<double>(m * m) * static_cast<double>(m * m) * static_cast<double>(m * m);
       bound > 1; bound /= 2) {
    ++bits;
  }
  // Towards zero in both divisions: 2^(6k - 2) >= 2^(min_exponent - 1), and 2^(6k + bits) < 2^max_exponent.
  return {(Limits::min_exponent + 1) / 6, (Limits::max_exponent - 1 - bits) / 6};
}
static_assert(LatticeBounds<float>::radius_in_halves <= 8 * LatticeBounds<float>::m);
static_assert(LatticeBounds<double>::radius_in_halves <= 8 * LatticeBounds<double>::m);

}  // namespace axiscert
