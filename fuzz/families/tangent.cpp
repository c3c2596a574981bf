// Radii solved onto each of the seven radius boundaries, the centre where that axis is the one that decides.
#include "fuzz/boundary.h"
#include "fuzz/families/shapes.h"
#include "fuzz/family.h"

namespace axiscert {
namespace {

// A point whose nearest triangle point lies inside the feature that the axis is named after.
template <class Real>
Vec3<Real> centre_beyond(Stream& random, const shapes::Vertices<Real>& vertices, std::size_t axis) {
  const auto [normal, outward] = shapes::directions(vertices);
  if (axis == 0) {
    const Real side = random.coin() ? Real(1) : Real(-1);
    const Vec3<Real> foot = shapes::inside(random, vertices);
    return foot + normal * (side * shapes::height<Real>(random));
  }
  const bool at_vertex = axis < 4;
  const std::size_t i = at_vertex ? axis - 1 : axis - 4;
  const Vec3<Real> foot = at_vertex ? vertices[i] : shapes::inside_edge(random, vertices, i);
  Vec3<Real> direction = outward[i] * (random.unit<Real>() + Real(0x1p-5));
  if (at_vertex) direction = direction + outward[shapes::opposite(i)] * (random.unit<Real>() + Real(0x1p-5));
  direction = direction + normal * random.symmetric<Real>();
  return foot + shapes::at_unit_length(direction) * shapes::height<Real>(random);
}

template <class Real>
Query<Real> tangent(Stream& random, std::uint64_t position) {
  const std::size_t axis = position % axis_count;
  const int ulps = static_cast<int>(position / axis_count % 9) - 4;
  const auto vertices = shapes::vertices_in_cube<Real>(random);
  Query<Real> q = shapes::query(vertices, centre_beyond(random, vertices, axis));
  q.r = step_radius(radius_on_boundary(q, radius_comparison(static_cast<Axis>(axis))), ulps);
  return q;
}

}  // namespace

extern const Family tangent_family = {
    "tangent",
    "radius on the boundary of each radius comparison in turn, -4 to +4 ulp, where that axis decides",
    1,
    false,
    tangent<float>,
    tangent<double>};

}  // namespace axiscert
