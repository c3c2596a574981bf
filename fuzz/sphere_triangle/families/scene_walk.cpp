// A character's sphere on a floor or a ramp, in metres: the queries that a controller asks at every frame of a game.
#include "fuzz/sphere_triangle/families/parts/scene.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/queries/family.h"

namespace axiscert {
namespace {

template <class Real>
Query<Real> scene_walk(Stream& random, std::uint64_t position) {
  const Real r = scenes::radius<Real>(random);
  const double height = static_cast<double>(r) + scenes::gap(random, position / 3);
  const auto centre = scenes::place(random, position / (3 * scenes::gap_count));
  const bool floor = random.coin();
  const auto axes = scenes::axes(random, floor);
  auto corners = scenes::triangle_of_ground(random);
  const auto foot = scenes::foot_on_ground(random, position % 3, corners, static_cast<double>(r));
  for (auto& corner : corners) corner = corner - foot;
  return scenes::query(random, centre, axes, corners, {0, 0, height}, r);
}

}  // namespace

extern const Family scene_walk_family = {
    sphere_triangle_predicate,
    "scene-walk",
    "metres: a character's sphere within 1 cm of resting on a floor or ramp, its triangles 1 cm to 100 m",
    1,
    false,
    fill_one_by_one<scene_walk<float>>,
    fill_one_by_one<scene_walk<double>>,
    TrustGroup::scene};

}  // namespace axiscert
