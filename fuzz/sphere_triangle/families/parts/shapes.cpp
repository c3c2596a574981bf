#include "fuzz/sphere_triangle/families/parts/shapes.h"

#include <cmath>

#include "fuzz/queries/floats.h"
#include "fuzz/sphere_triangle/families/parts/boundary.h"

namespace axiscert::shapes {

std::array<std::int64_t, 3> weights(Stream& random, Axis axis, std::int64_t parts) {
  std::array<std::int64_t, 3> w{};
  const auto number = index_of(axis);
  if (axis == Axis::plane) {
    w[0] = random.integer(1, parts - 2);
    w[1] = random.integer(1, parts - 1 - w[0]);
    w[2] = parts - w[0] - w[1];
  } else if (number < 4) {
    w[number - 1] = parts;
  } else {
    w[number - 4] = random.integer(1, parts - 1);
    w[next(number - 4)] = parts - w[number - 4];
  }
  return w;
}

template <class Real>
Vec3<Real> scaled(const Vec3<Real>& v, int exponent) {
  return v * std::ldexp(Real(1), exponent);
}

template <class Real>
Real radius_near_distance(Stream& random, const Query<Real>& q, int ulps) {
  return step_radius(radius_at_distance(q), static_cast<int>(random.integer(-ulps, ulps)));
}

template <class Real>
void solve_aimed_radii(const MutableColumns<Real>& queries, const Wishes<Real>& wishes) {
  for (std::size_t i = 0; i < queries.size; ++i) {
    if (wishes[1][i] == 0) continue;
    const Real distance = radius_at_distance(query_from(queries[i]));
    queries.column[12][i] = step_radius(distance, static_cast<int>(wishes[0][i])) * wishes[1][i];
  }
}

#define AXISCERT_INSTANTIATE(Real)                                            \
  template Vec3<Real> scaled<Real>(const Vec3<Real>&, int);                   \
  template Real radius_near_distance<Real>(Stream&, const Query<Real>&, int); \
  template void solve_aimed_radii<Real>(const MutableColumns<Real>&, const Wishes<Real>&);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

}  // namespace axiscert::shapes
