// Motions in metres, as a game asks for them at every frame: a character's steps, balls that fall on seams, bullets,
// and a camera that shakes.
#include "fuzz/moving_sphere/parts.h"
#include "fuzz/sphere_triangle/families/parts/scene.h"

namespace axiscert::moving_sphere {
namespace {

using scenes::Point;

// A motion by `step` near a triangle of ground whose foot below the sphere is the origin.
struct Frame {
  std::array<Point, 3> corners;
  Point sphere, step;
};

// Somewhere in a level. Every other time the displacement is the difference of two places that were rounded, as where
// an engine keeps places; else it is rounded itself, as where it keeps a velocity.
template <class Real>
MovingQuery<Real> in_level(Stream& random, std::uint64_t which_place, const Frame& frame, Real r) {
  const Point centre = scenes::place(random, which_place);
  const bool is_level = random.coin();
  const scenes::Axes axes = scenes::axes(random, is_level);
  const bool keeps_places = random.coin();
  Stream again = random, wide_again = random, wide_end = random;
  const Query<Real> end = scenes::query(again, centre, axes, frame.corners, frame.sphere + frame.step, r);
  const Point from = scenes::query(wide_again, centre, axes, frame.corners, frame.sphere, 0.0).p,
              to = scenes::query(wide_end, centre, axes, frame.corners, frame.sphere + frame.step, 0.0).p,
              by = to - from;
  const Query<Real> start = scenes::query(random, centre, axes, frame.corners, frame.sphere, r);
  const Vec3<Real> rounded = {static_cast<Real>(by.x), static_cast<Real>(by.y), static_cast<Real>(by.z)};
  return {start.a, start.b, start.c, start.p, keeps_places ? end.p - start.p : rounded, r};
}

std::array<Point, 3> ground_about(Stream& random, std::uint64_t which, double r) {
  std::array<Point, 3> corners = scenes::triangle_of_ground(random);
  const Point foot = scenes::foot_on_ground(random, which, corners, r);
  for (Point& corner : corners) corner = corner - foot;
  return corners;
}

// From 0.5 to 8 m/s, in a sixtieth of a second; every other time with the fall of a frame.
template <class Real>
Numbers<Real> walking(Stream& random, std::uint64_t position) {
  const Real r = scenes::radius<Real>(random);
  const double wide = static_cast<double>(r);
  const double height = wide + scenes::gap(random, position / 3);
  Frame frame;
  frame.corners = ground_about(random, position % 3, wide);
  frame.sphere = {0, 0, height};
  const double speed = scenes::length(random, 0.5, 4, 8), x = random.symmetric<double>(),
               y = random.symmetric<double>();
  const bool falls = random.coin();
  const Point way = x == 0 && y == 0 ? Point{1, 0, 0} : scenes::at_unit_length({x, y, 0});
  frame.step = way * (speed / 60) + Point{0, 0, falls ? -9.81 / 3600 : 0};
  return in_level<Real>(random, position / (3 * scenes::gap_count), frame, r);
}

// From up to 2 m above the ground, for two of three at its edges and corners, to where it rests, stops short or sinks
// in.
template <class Real>
Numbers<Real> falling(Stream& random, std::uint64_t position) {
  const Real r = scenes::radius<Real>(random);
  const double wide = static_cast<double>(r);
  const double height = wide + scenes::gap(random, position / 3), fall = scenes::length(random, 0.01, 8, 2);
  Frame frame;
  frame.corners = ground_about(random, position % 3, wide);
  frame.sphere = {0, 0, height + fall};
  frame.step = {0, 0, -fall};
  return in_level<Real>(random, position / (3 * scenes::gap_count), frame, r);
}

// 60 to 1,000 m/s: 1 to 17 m in a frame, of a radius of 2 mm to 1 cm or, for a third, a point.
template <class Real>
Numbers<Real> shot(Stream& random, std::uint64_t position) {
  const double share = random.unit<double>(), far = scenes::length(random, 1, 5, 17), passed = random.unit<double>();
  const double wide = position / 3 % 3 == 0 ? 0 : 0.002 + 0.008 * share;
  Frame frame;
  frame.corners = ground_about(random, position % 3, wide);
  const Point any = shapes::in_cube<double>(random);
  const Point way = any.x == 0 && any.y == 0 && any.z == 0 ? Point{0, 0, 1} : scenes::at_unit_length(any);
  frame.sphere = way * (-far * passed);
  frame.step = way * far;
  return in_level<Real>(random, position / 9, frame, static_cast<Real>(wide));
}

// By a micrometre to a millimetre in any direction, next to a wall or in it.
template <class Real>
Numbers<Real> shaking(Stream& random, std::uint64_t position) {
  const Real r = scenes::radius<Real>(random);
  const double wide = static_cast<double>(r);
  const double height = wide + scenes::gap(random, position / 3), far = scenes::length(random, 1e-6, 10, 1e-3);
  Frame frame;
  frame.corners = ground_about(random, position % 3, wide);
  frame.sphere = {0, 0, height};
  const Point any = shapes::in_cube<double>(random);
  frame.step = (any.x == 0 && any.y == 0 && any.z == 0 ? Point{0, 0, 1} : scenes::at_unit_length(any)) * far;
  return in_level<Real>(random, position / (3 * scenes::gap_count), frame, r);
}

}  // namespace

extern const Family moving_sphere_scene_walk_family = in_metres(moving_family<walking<float>, walking<double>>(
    "moving-sphere/scene_walk", situation::everyday,
    "metres: a character's step of a frame along a floor or ramp, within 1 cm of resting"));
extern const Family moving_sphere_scene_fall_family = in_metres(moving_family<falling<float>, falling<double>>(
    "moving-sphere/scene_fall", situation::everyday,
    "metres: a ball that falls by up to 2 m on the face, a seam or a corner"));
extern const Family moving_sphere_scene_bullet_family = in_metres(
    moving_family<shot<float>, shot<double>>("moving-sphere/scene_bullet", situation::everyday,
                                             "metres: a point or a bullet of millimetres, 1 to 17 m in a frame"));
extern const Family moving_sphere_scene_shake_family = in_metres(moving_family<shaking<float>, shaking<double>>(
    "moving-sphere/scene_shake", situation::everyday,
    "metres: a camera that moves by a micrometre to a millimetre at a wall"));

}  // namespace axiscert::moving_sphere
