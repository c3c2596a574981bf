// Centres close to the triangle, on either side: spheres sunk in by nearly all of their radius, where a push goes to
// the other side for a rounding; and centres beside the triangle close to its plane, where the nearest part does.
#include <cmath>

#include "fuzz/queries/family.h"
#include "fuzz/queries/random.h"
#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

// In turn close to the face, each vertex and each edge; every fourth round beside the triangle, the weight of the
// opposite vertex or of the edge's being below 0. Then the power of two by which it is close, in turn too.
template <class Real>
Query<Real> sunken(Stream& random, std::uint64_t position) {
  constexpr std::uint64_t powers = sizeof(Real) == 4 ? 28 : 60;
  const auto axis = static_cast<Axis>(position % axis_count);
  const std::uint64_t round = position / axis_count;
  const auto vertices = shapes::vertices_in_cube<Real>(random);
  auto w = shapes::weights(random, axis, 64);
  if (round % 4 == 3) {
    const auto away = static_cast<std::size_t>(random.below(3));
    const std::int64_t by = random.integer(1, 64);
    w[away] -= by;
    w[shapes::next(away)] += by;
  }
  Vec3<Real> foot{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) foot = foot + vertices[i] * (static_cast<Real>(w[i]) / 64);
  const Vec3<Real> normal = cross(vertices[1] - vertices[0], vertices[2] - vertices[0]);
  const Vec3<Real> anywhere = shapes::in_cube<Real>(random);
  const bool is_across = axis == Axis::plane || round % 4 == 3 || random.coin();
  const Vec3<Real> along = is_across ? normal : anywhere;
  const Real size = std::sqrt(dot(along, along));
  const Real r = Real(0.125) + 2 * random.unit<Real>();
  const Real height = std::ldexp(Real(0.5) + random.unit<Real>() / 2, -static_cast<int>(round / 4 % powers));
  const Real signed_height = random.coin() ? height : -height;
  const Vec3<Real> p = size > 0 ? foot + along * (r * signed_height / size) : foot;
  return shapes::query(vertices, p, r);
}

}  // namespace

extern const Family sunken_family =
    by_name({sphere_triangle_predicate, "sunken",
             "the centre 2^-1 to 2^-28 (2^-60) of r from the face, each vertex and edge, on both "
             "sides, or beside them near the plane",
             1, false, fill_one_by_one<sunken<float>>, fill_one_by_one<sunken<double>>});

}  // namespace axiscert
