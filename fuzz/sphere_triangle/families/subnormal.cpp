// Coordinates that are subnormal or near the least normal number, where every product underflows.
#include <cmath>
#include <limits>

#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/random.h"

namespace axiscert {
namespace {

// In turn: all subnormal, and of sizes within 2^-12 to 2^12 of the least normal number.
template <class Real>
Query<Real> subnormal(Stream& random, std::uint64_t position) {
  constexpr int least_normal = std::numeric_limits<Real>::min_exponent - 1;
  const int size = position % 2 == 0 ? 0 : static_cast<int>(random.integer(-12, 12));
  std::array<Real, coordinate_count> v;
  const Real unit = std::ldexp(Real(1), least_normal + size);  // exact, so a product rounds once, as ldexp does
  for (Real& x : v) x = random.symmetric<Real>() * unit;
  v[12] = std::abs(v[12]);
  Query<Real> q = from_coordinates(v);
  if (position / 2 % 4 == 3) q.r = shapes::radius_near_distance(random, q, 2);
  return q;
}

}  // namespace

extern const Family subnormal_family = {
    sphere_triangle_predicate,
    "subnormal",
    "all subnormal, or within 2^12 of the least normal number; a quarter of the radii at the distance",
    2,
    false,
    fill_one_by_one<subnormal<float>>,
    fill_one_by_one<subnormal<double>>,
    TrustGroup::small};

}  // namespace axiscert
