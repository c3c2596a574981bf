#include "fuzz/sphere_triangle/search_box.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "kernel/arithmetic/error_free.h"
#include "kernel/base/powers_of_two.h"

namespace axiscert {
namespace {

// The greatest distance of a coordinate from the origin: beyond it adjacent numbers are more than 1 apart.
template <class Real>
constexpr Real farthest = static_cast<Real>(std::uint64_t{1} << std::numeric_limits<Real>::digits);
constexpr std::size_t radius_place = coordinate_count - 1;

// The place of a coordinate of a vertex or, with v = 3, of the centre: 3 v + axis.
constexpr std::size_t place_of(std::size_t vertex, std::size_t axis) { return 3 * vertex + axis; }

}  // namespace

template <class Real>
bool is_within_one(Real a, Real p) {
  const auto difference = arithmetic::two_sum(a, Real(-p));
  const Real size = std::fabs(difference.value);
  const Real beyond = difference.value > 0 ? difference.error : Real(-difference.error);
  return size < 1 || (size == 1 && beyond <= 0);
}

template <class Real>
bool is_in_box(const Query<Real>& q) {
  if (q.r > 1) return false;
  for (const Vec3<Real>& v : {q.a, q.b, q.c}) {
    if (!is_within_one(v.x, q.p.x) || !is_within_one(v.y, q.p.y) || !is_within_one(v.z, q.p.z)) return false;
  }
  return true;
}

template <class Real>
void settle(Query<Real>& q) {
  auto v = coordinates(q);
  for (Real& x : v) {
    if (!(std::fabs(x) <= farthest<Real>)) x = std::isnan(x) ? Real(0) : std::copysign(farthest<Real>, x);
  }
  v[radius_place] = std::min(std::fabs(v[radius_place]), Real(1));
  Real greatest = v[radius_place];
  for (std::size_t vertex = 0; vertex < 3; ++vertex) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Real& x = v[place_of(vertex, axis)];
      const Real p = v[place_of(3, axis)];
      // Rounding is monotone: if the rounded difference is less than 1, so is the exact one.
      if (std::fabs(x - p) >= 1 && !is_within_one(x, p)) {
        x = p + (x > p ? Real(1) : Real(-1));
        while (!is_within_one(x, p)) x = std::nextafter(x, p);
      }
      greatest = std::max(greatest, std::fabs(x - p));
    }
  }
  if (greatest > 0 && greatest < Real(0.5)) {
    Real most = greatest;
    for (const Real x : v) most = std::max(most, std::fabs(x));
    const int up = std::min(-1 - std::ilogb(greatest), std::numeric_limits<Real>::digits - 1 - std::ilogb(most));
    if (up > 0) scale_by_power_of_two(v, up);
  }
  q = from_coordinates(v);
}

#define AXISCERT_INSTANTIATE(Real)             \
  template bool is_within_one(Real, Real);     \
  template bool is_in_box(const Query<Real>&); \
  template void settle(Query<Real>&);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

}  // namespace axiscert
