// Centres exactly on the triangle in coordinates of few bits, as in a level made on a grid: plane offsets and
// determinants that `on` leaves to rounding are exactly zero here. Iterations that wait for a sign can then run for
// ever.
#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/random.h"

namespace axiscert {
namespace {

// Vertices that are four times integers give a centre in integers.
template <class Real>
Query<Real> grid(Stream& random, std::uint64_t position) {
  constexpr std::array<std::int64_t, 3> bounds = {2, 8, 64};
  const std::int64_t bound = bounds[position / axis_count % bounds.size()];
  const auto w = shapes::weights(random, static_cast<Axis>(position % axis_count), 4);
  shapes::Vertices<Real> vertices;
  Vec3<Real> p{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto vertex = shapes::integers<Real>(random, bound);
    vertices[i] = vertex * Real(4);
    p = p + vertex * static_cast<Real>(w[i]);
  }
  const Real radii[] = {0, Real(-0.0), 1, static_cast<Real>(random.integer(1, 4 * bound))};
  return shapes::query(vertices, p, radii[random.below(4)]);
}

}  // namespace

extern const Family grid_family = {
    sphere_triangle_predicate,
    "grid",
    "small integers, the centre exactly on the face, a vertex or an edge in turn; r 0, -0, 1 and small integers",
    2,
    false,
    fill_one_by_one<grid<float>>,
    fill_one_by_one<grid<double>>};

}  // namespace axiscert
