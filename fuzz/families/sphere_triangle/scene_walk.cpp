// A character's sphere on a floor or a ramp, in metres: the queries that a controller asks at every frame of a game.
#include "fuzz/families/sphere_triangle/parts/scene.h"
#include "fuzz/queries/one_by_one.h"

namespace axiscert {
namespace {

// In the ground's plane: two legs, the longer up to four times the shorter, at an angle of 20 to 120 degrees, so that
// no angle is below 6 degrees.
std::array<Vec3<double>, 3> triangle_of_ground(Stream& random) {
  const double shorter = scenes::any_length(random);
  const double longer = std::fmin(shorter * (1 + 3 * random.unit<double>()), 100);
  const double cosine = -0.5 + 1.4375 * random.unit<double>(), sine = std::sqrt(1 - cosine * cosine);
  const bool longer_first = random.coin();
  const double first = longer_first ? longer : shorter, second = longer_first ? shorter : longer;
  return {{{0, 0, 0}, {first, 0, 0}, {second * cosine, second * sine, 0}}};
}

// The point of the ground below the sphere: in turn inside the triangle, and at an edge and at a vertex, there for half
// of the queries exactly and for the others up to half a radius to each side.
Vec3<double> foot_on_ground(Stream& random, std::uint64_t which, const std::array<Vec3<double>, 3>& v, double r) {
  const auto feature = static_cast<std::size_t>(random.below(3));
  double share[3];
  for (double& s : share) s = random.unit<double>() + 0x1p-5;
  const bool beside = random.coin();
  const double aside = random.symmetric<double>() * r / 2, ahead = random.symmetric<double>() * r / 2;
  if (which == 0) {
    const double sum = (share[0] + share[1]) + share[2];
    return (v[0] * (share[0] / sum) + v[1] * (share[1] / sum)) + v[2] * (share[2] / sum);
  }
  const auto& from = v[feature];
  const double part = which == 1 ? share[0] / (1 + 0x1p-4) : 0;
  const Vec3<double> on_feature = from + (v[shapes::next(feature)] - from) * part;
  return beside ? on_feature + Vec3<double>{aside, ahead, 0} : on_feature;
}

template <class Real>
Query<Real> scene_walk(Stream& random, std::uint64_t position) {
  const Real r = scenes::radius<Real>(random);
  const double height = static_cast<double>(r) + scenes::gap(random, position / 3);
  const auto centre = scenes::place(random, position / (3 * scenes::gap_count));
  const bool floor = random.coin();
  const auto axes = scenes::axes(random, floor);
  auto corners = triangle_of_ground(random);
  const auto foot = foot_on_ground(random, position % 3, corners, static_cast<double>(r));
  for (auto& corner : corners) corner = corner - foot;
  return scenes::query(random, centre, axes, corners, {0, 0, height}, r);
}

}  // namespace

extern const Family scene_walk_family = {
    "scene-walk",
    "metres: a character's sphere within 1 cm of resting on a floor or ramp, its triangles 1 cm to 100 m",
    1,
    false,
    one_by_one<scene_walk<float>>,
    one_by_one<scene_walk<double>>};

}  // namespace axiscert
