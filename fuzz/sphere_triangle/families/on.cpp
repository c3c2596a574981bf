// Centres exactly on the triangle, at a vertex, on an edge or on the face: every query is a contact, and touching at r
// = 0.
#include <cmath>
#include <limits>

#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/random.h"

namespace axiscert {
namespace {

template <class Real>
Real small_radius(Stream& random, std::uint64_t which) {
  switch (which) {
    case 0:
      return 0;
    case 1:
      return Real(-0.0);
    case 2:
      return std::numeric_limits<Real>::denorm_min();
    case 3: {
      const Real significand = random.unit<Real>();
      return std::ldexp(significand, -static_cast<int>(random.integer(20, 120)));
    }
    default:
      return random.unit<Real>() / 16;
  }
}

// Vertices that are sixteen times integers give a centre in integers.
template <class Real>
Query<Real> on(Stream& random, std::uint64_t position) {
  constexpr int digits = sizeof(Real) == 4 ? 20 : 49;
  const auto w = shapes::weights(random, static_cast<Axis>(position % axis_count), 16);
  shapes::Vertices<Real> vertices;
  Vec3<Real> p{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto vertex = shapes::integers<Real>(random, std::int64_t{1} << digits);
    vertices[i] = shapes::scaled(vertex, -digits);
    p = p + shapes::scaled(vertex * static_cast<Real>(w[i]), -digits - 4);
  }
  return shapes::query(vertices, p, small_radius<Real>(random, position / axis_count % 5));
}

}  // namespace

extern const Family on_family = {
    sphere_triangle_predicate,
    "on",
    "centre exactly on the face, a vertex or an edge in turn; r of 0, -0, the least, tiny and small",
    2,
    false,
    fill_one_by_one<on<float>>,
    fill_one_by_one<on<double>>,
    TrustGroup::resting};

}  // namespace axiscert
