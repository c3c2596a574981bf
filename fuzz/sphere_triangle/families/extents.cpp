// Lengths that differ by much in one scene, in metres: strips 200 m long and 1 mm to 1 m wide, as roads, rails and
// walls are triangulated, and triangles of millimetres and of kilometres, beside spheres of 1 cm to 1 m.
#include "fuzz/queries/family.h"
#include "fuzz/sphere_triangle/families/parts/scene.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using scenes::Point;

// In turn a strip, a speck of 1 to 16 mm and a plain of 0.5 to 8 km, the sphere within 1 cm of touching it in turn at
// the face, an edge and a vertex.
template <class Real>
Query<Real> mixed_lengths(Stream& random, std::uint64_t position) {
  const std::uint64_t kind = position % 3, part = position / 3 % 3;
  const auto r = static_cast<Real>(scenes::length(random, 0.01, 7, 1));
  const double height = static_cast<double>(r) + scenes::gap(random, position / 9);
  const auto world = scenes::place(random, position / (9 * scenes::gap_count));
  const auto axes = scenes::axes(random, random.coin());
  const double width = scenes::length(random, 0.001, 10, 1), speck = scenes::length(random, 0.001, 4, 0.016),
               plain = scenes::length(random, 500, 4, 8000), share = random.unit<double>();
  const double length = kind == 0   ? 200
                        : kind == 1 ? speck
                                    : plain,
               across = kind == 0 ? width : length * (0.5 + share / 2);
  std::array<Point, 3> corners = {{{0, 0, 0}, {length, 0, 0}, {kind == 0 ? 0 : length * share, across, 0}}};
  const auto foot = scenes::foot_on_ground(random, part, corners, static_cast<double>(r));
  for (Point& corner : corners) corner = corner - foot;
  return scenes::query(random, world, axes, corners, {0, 0, height}, r);
}

}  // namespace

extern const Family extents_family =
    by_name({sphere_triangle_predicate, "extents",
             "metres: triangles 200 m long and 1 mm to 1 m wide, of millimetres and of "
             "kilometres; spheres of 1 cm to 1 m near touching",
             1, false, fill_one_by_one<mixed_lengths<float>>, fill_one_by_one<mixed_lengths<double>>});

}  // namespace axiscert
