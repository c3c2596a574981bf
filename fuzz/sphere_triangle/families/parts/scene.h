// Scenes in metres, as a game has them: a character's sphere held near triangles somewhere in a level. Everything is
// computed in binary64, also for binary32, and rounded once, as a level is when it is exported.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "fuzz/queries/random.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::scenes {

using Point = Vec3<double>;

// The numbers of places `place` and heights `gap` to choose from in turn.
inline constexpr std::uint64_t place_count = 3, gap_count = 3;

// The centre of the scene: each coordinate within 10 m, 100 m or 1 km of the origin.
inline Point place(Stream& random, std::uint64_t which) {
  constexpr std::array<double, place_count> extents = {10, 100, 1000};
  return shapes::in_cube<double>(random) * extents[which % place_count];
}

// The sphere's radius in metres: 0.3 or, for half of the queries, from 0.1 to 1. It is a number of the precision, so
// that a sphere can rest at this very height.
template <class Real>
Real radius(Stream& random) {
  const bool usual = random.coin();
  const double share = random.unit<double>();
  return static_cast<Real>(usual ? 0.3 : 0.1 + 0.9 * share);
}

// How far the sphere is from touching, in metres: at rest; with the skin of 1 mm to 1 cm that a controller keeps; sunk
// in by up to 1 cm.
inline double gap(Stream& random, std::uint64_t which) {
  const double share = random.unit<double>();
  switch (which % gap_count) {
    case 0:
      return 0;
    case 1:
      return 0.001 + 0.009 * share;
    default:
      return -0.01 * share;
  }
}

// From `least` to `greatest` metres, with its logarithm spread evenly over `octaves` octaves from `least` on.
inline double length(Stream& random, double least, int octaves, double greatest) {
  const auto octave = static_cast<int>(random.integer(0, octaves - 1));
  const double significand = 1 + random.unit<double>();
  return std::fmin(std::ldexp(least * significand, octave), greatest);
}
// 1 cm to 100 m.
inline double any_length(Stream& random) { return length(random, 0.01, 14, 100); }

inline Point at_unit_length(const Point& v) { return v / std::sqrt(dot(v, v)); }

// Axes of the scene, at right angles up to rounding. Level ones are, for half of the scenes, along the world's; the
// others are turned about the vertical. `up` of a slope is at most 60 degrees from the vertical.
struct Axes {
  Point x, y, up;
  Point at(const Point& local) const { return x * local.x + y * local.y + up * local.z; }
};
inline Axes axes(Stream& random, bool level) {
  constexpr double steepest = 1.22;  // times the root of 2: below the tangent of 60 degrees
  const double east = random.symmetric<double>() * steepest, north = random.symmetric<double>() * steepest;
  const Point up = level ? Point{0, 0, 1} : at_unit_length({east, north, 1});
  const Point across = at_unit_length(cross(Point{0, 1, 0}, up));
  const Point along = cross(up, across);
  const bool aligned = random.coin();
  // The half angle's tangent: a turn by -90 to 90 degrees.
  const double tangent = random.symmetric<double>(), scale = 1 + tangent * tangent;
  const double cosine = aligned ? 1 : (1 - tangent * tangent) / scale, sine = aligned ? 0 : 2 * tangent / scale;
  const Point x = across * cosine + along * sine;
  return {x, cross(up, x), up};
}

// In the ground's plane: two legs, the longer up to four times the shorter, at an angle of 20 to 120 degrees, so that
// no angle is below 6 degrees.
inline std::array<Point, 3> triangle_of_ground(Stream& random) {
  const double shorter = any_length(random);
  const double longer = std::fmin(shorter * (1 + 3 * random.unit<double>()), 100);
  const double cosine = -0.5 + 1.4375 * random.unit<double>(), sine = std::sqrt(1 - cosine * cosine);
  const bool longer_first = random.coin();
  const double first = longer_first ? longer : shorter, second = longer_first ? shorter : longer;
  return {{{0, 0, 0}, {first, 0, 0}, {second * cosine, second * sine, 0}}};
}

// The point of the ground below the sphere: in turn inside the triangle, and at an edge and at a vertex, there for half
// of the queries exactly and for the others up to half a radius to each side.
inline Point foot_on_ground(Stream& random, std::uint64_t which, const std::array<Point, 3>& v, double r) {
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
  const Point on_feature = from + (v[shapes::next(feature)] - from) * part;
  return beside ? on_feature + Point{aside, ahead, 0} : on_feature;
}

// The query of local points around `centre`. The third coordinate of the world is up or, for half of the scenes, the
// second; the triangle begins with any of its vertices. Both keep its orientation.
template <class Real>
Query<Real> query(Stream& random, const Point& centre, const Axes& axes, const std::array<Point, 3>& corners,
                  const Point& sphere, Real r) {
  const bool second_is_up = random.coin();
  const auto first = static_cast<std::size_t>(random.below(3));
  const auto rounded = [&](const Point& local) {
    const Point p = centre + axes.at(local), turned = second_is_up ? Point{p.y, p.z, p.x} : p;
    return Vec3<Real>{static_cast<Real>(turned.x), static_cast<Real>(turned.y), static_cast<Real>(turned.z)};
  };
  const auto corner = [&](std::size_t i) { return rounded(corners[(first + i) % 3]); };
  return {corner(0), corner(1), corner(2), rounded(sphere), r};
}

}  // namespace axiscert::scenes
