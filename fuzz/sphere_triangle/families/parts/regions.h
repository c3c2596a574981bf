// Points of a triangle and directions from them in which they are its nearest points: the seven regions of a triangle,
// and the ends of its edges. In doubles, so that a margin of a hundredth is one whatever was rounded before.
#pragma once

#include <array>
#include <cmath>

#include "fuzz/sphere_triangle/families/parts/scene.h"

namespace axiscert::regions {

using scenes::at_unit_length, scenes::Point;
using Corners = std::array<Point, 3>;

// Vertices a, b, c; edges ab, bc, ca in the middle, near their first end and near their second; the face.
inline constexpr std::size_t count = 13;
constexpr bool is_vertex(std::size_t region) { return region < 3; }
constexpr bool is_edge(std::size_t region) { return 3 <= region && region < 12; }

// A point of the region and a unit vector: at any distance that way it is the nearest point of the triangle.
struct Aim {
  Point at, away;
};

// Points of the outside of edge i in the plane of the triangle.
inline Point outwards(const Corners& v, std::size_t i) {
  const Point normal = cross(v[1] - v[0], v[2] - v[0]);
  return at_unit_length(cross(v[shapes::next(i)] - v[i], normal));
}

// At random in a region of a triangle that has an area. Near an end is within `near` of it, and within half the edge.
inline Aim aim(Stream& random, const Corners& v, std::size_t region, double near) {
  const Point normal = at_unit_length(cross(v[1] - v[0], v[2] - v[0]));
  const double one = random.unit<double>() + 0x1p-4, other = random.unit<double>() + 0x1p-4,
               third = random.unit<double>() + 0x1p-4, up = random.symmetric<double>();
  const bool is_level = random.coin();
  const Point rise = normal * (is_level ? 0 : up);
  const std::size_t i = region % 3;
  if (is_vertex(region)) {
    const Point to_next = at_unit_length(v[shapes::next(i)] - v[i]), to_last = at_unit_length(v[(i + 2) % 3] - v[i]);
    const Point out = outwards(v, i) * one + outwards(v, (i + 2) % 3) * other - (to_next + to_last) * third;
    return {v[i], at_unit_length(at_unit_length(out) + rise)};
  }
  if (!is_edge(region)) {
    const double sum = (one + other) + third;
    return {(v[0] * one + v[1] * other + v[2] * third) / sum, up < 0 ? normal * -1.0 : normal};
  }
  const Point edge = v[shapes::next(i)] - v[i];
  const double length = std::sqrt(dot(edge, edge)), part = std::fmin(near / length, 0.5) * one / (1 + 0x1p-4);
  const double along = region < 6 ? one / (1 + 0x1p-3) : region < 9 ? part : 1 - part;
  return {v[i] + edge * along, at_unit_length(outwards(v, i) + rise)};
}

// A part of a length by which a sphere is clearly in contact, or clearly not: 1 to 30 in a hundred, half of them
// below 8.
inline double clear_part(Stream& random) {
  const double part = random.unit<double>();
  return 0.01 + 0.29 * (part * part);
}

// A unit vector at right angles to one.
inline Point at_right_angles(Stream& random, const Point& way) {
  for (;;) {
    const Point any = shapes::in_cube<double>(random), across = any - way * dot(any, way);
    if (dot(across, across) > 0x1p-8) return at_unit_length(across);
  }
}

// A triangle with the angle of that cosine at vertex 0, and the two lengths of its sides there; in any direction.
inline Corners with_corner(Stream& random, double cosine, double first, double second) {
  const Point from = shapes::in_cube<double>(random);
  Point way = shapes::in_cube<double>(random);
  if (dot(way, way) < 0x1p-8) way = {1, 0, 0};
  way = at_unit_length(way);
  const Point aside = at_right_angles(random, way);
  return {from, from + way * first, from + (way * cosine + aside * std::sqrt(1 - cosine * cosine)) * second};
}

template <class Real>
Vec3<Real> rounded_place(const Point& p) {
  return {static_cast<Real>(p.x), static_cast<Real>(p.y), static_cast<Real>(p.z)};
}
// Not inlined: g++ 12 with -O2 drops the rounding to float where it makes vectors of both conversions.
template <class Real>
[[gnu::noinline]] Point wide(const Vec3<Real>& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

}  // namespace axiscert::regions
