// Queries far from the origin, where the grid of the floats is coarse against the triangle.
#include "fuzz/families/shapes.h"
#include "fuzz/family.h"

namespace axiscert {
namespace {

template <class Real>
Query<Real> far(Stream& random, std::uint64_t position) {
  constexpr std::array<Real, 5> decades = {Real(1e2), Real(1e3), Real(1e4), Real(1e5), Real(1e6)};
  const auto vertices = shapes::vertices_in_cube<Real>(random);
  const Vec3<Real> p = shapes::in_cube<Real>(random);
  const Vec3<Real> offset = shapes::at_unit_length(shapes::in_cube<Real>(random)) * decades[position % 5];
  Query<Real> q{vertices[0] + offset, vertices[1] + offset, vertices[2] + offset, p + offset, 0};
  q.r = shapes::aimed_radius(random, q);  // of the rounded query
  return q;
}

}  // namespace

extern const Family far_family = {
    "far",      "triangles of size one at 10^2 to 10^6 from the origin, half of the radii near the distance",
    1,          false,
    far<float>, far<double>};

}  // namespace axiscert
