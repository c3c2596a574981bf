// Triangles with one vertex almost on the segment of the other two, down to heights far below the rounding of their
// coordinates.
#include <cmath>

#include "fuzz/families/shapes.h"
#include "fuzz/family.h"

namespace axiscert {
namespace {

// The segment runs through the origin exactly, from -m D to n D in few-bit integers, so that the third vertex, near the
// origin where floats are dense, can be as near to it as it likes. Half of the triangles are then moved away, where
// rounding the coordinates limits the ratio.
template <class Real>
Query<Real> sliver(Stream& random, std::uint64_t position) {
  constexpr int half_digits = sizeof(Real) == 4 ? 11 : 25;
  constexpr int most_halvings = sizeof(Real) == 4 ? 40 : 80;
  const int halvings = 1 + static_cast<int>(position % most_halvings);
  const auto d = shapes::integers<Real>(random, std::int64_t{1} << half_digits);
  const auto m = static_cast<Real>(random.integer(1, std::int64_t{1} << half_digits));
  const auto n = static_cast<Real>(random.integer(1, std::int64_t{1} << half_digits));
  const Vec3<Real> x = shapes::scaled(d * -m, -2 * half_digits), y = shapes::scaled(d * n, -2 * half_digits);

  const Vec3<Real> along = y - x, aside = shapes::at_unit_length(cross(along, shapes::in_cube<Real>(random)));
  const Vec3<Real> z = shapes::scaled(aside * std::sqrt(dot(along, along)), -halvings);
  const auto vertices = shapes::shuffled<Real>(random, {x, y, z});

  Query<Real> q = shapes::placed(random, vertices, halvings);
  q.r = shapes::aimed_radius(random, q);
  return q;
}

}  // namespace

extern const Family sliver_family = {
    "sliver",
    "one vertex near the segment of the other two, at 2^-1 to 2^-40 of its length (2^-80 in binary64)",
    1,
    false,
    sliver<float>,
    sliver<double>};

}  // namespace axiscert
