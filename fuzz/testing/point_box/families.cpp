#include <algorithm>
#include <array>

#include "fuzz/queries/family.h"
#include "fuzz/testing/point_box/point_box.h"

namespace axiscert {
namespace {

// The columns are p, then the low and the high corner.
template <class Real>
Numbers<Real> point_and_box(Stream& random, std::uint64_t) {
  Numbers<Real> q(9);
  for (std::size_t k = 0; k < 3; ++k) {
    const Real one = random.symmetric<Real>(), other = random.symmetric<Real>();
    q[k] = random.symmetric<Real>();
    q[3 + k] = std::min(one, other);
    q[6 + k] = std::max(one, other);
  }
  return q;
}

// The faces in turn.
template <class Real>
Numbers<Real> on_the_surface(Stream& random, std::uint64_t position) {
  Numbers<Real> q = point_and_box<Real>(random, position);
  for (std::size_t k = 0; k < 3; ++k) q[k] = std::clamp(q[k], q[3 + k], q[6 + k]);
  const std::size_t axis = position / 2 % 3;
  q[axis] = q[(position % 2 == 0 ? 3 : 6) + axis];
  return q;
}

template <auto one32, auto one64>
constexpr Family family(std::string_view name, std::string_view purpose) {
  return {.predicate = point_box_predicate,
          .name = name,
          .purpose = purpose,
          .version = 1,
          .exact_arithmetic = true,
          .binary32 = fill_one_by_one<one32, float>,
          .binary64 = fill_one_by_one<one64, double>};
}
const Family general_point =
    family<point_and_box<float>, point_and_box<double>>("point-box/general", "point and box anywhere in [-1, 1]");
const Family surface_point =
    family<on_the_surface<float>, on_the_surface<double>>("point-box/surface", "the point on each face in turn");

}  // namespace

std::span<const Family* const> point_box_families() {
  static const Family* const all[] = {&general_point, &surface_point};
  return all;
}

}  // namespace axiscert
