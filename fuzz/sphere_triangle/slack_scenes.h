// Triangles and their features as scenes of slacks have them, for spheres that stand and spheres that move.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "fuzz/confirm/slack_scenes.h"
#include "fuzz/queries/random.h"

namespace axiscert {

extern const SlackScenes sphere_triangle_slack_scenes;

namespace slack {

// All angles are between 35 and 85 degrees, about; the sides are from 1 to 2 long, and 0 is within 1/4 of the triangle.
struct SceneTriangle {
  std::array<ScenePoint, 3> corner;
  ScenePoint normal;  // of length 1, on the front or the back

  ScenePoint along(std::size_t edge) const { return corner[(edge + 1) % 3] - corner[edge]; }
  // A vector of length 1, in the plane and away from the triangle.
  ScenePoint outward(std::size_t edge) const;
  double altitude(std::size_t edge) const { return dot(corner[edge] - corner[(edge + 2) % 3], outward(edge)); }
};
SceneTriangle random_triangle(Stream& random);

// A direction of length 1 in any part of the sphere.
ScenePoint random_direction(Stream& random);
// From 2^low to 2^high, as likely in each binade.
double random_length(Stream& random, int low, int high);

enum class Nearest : std::uint8_t { face, edge, vertex };
// A point of the triangle, and the direction, of length 1, of the places to which it is the nearest: well within these.
// `which` is the edge or the vertex, or of the face the front, 0, or the back.
struct NearestScene {
  ScenePoint point, away;
};
NearestScene nearest_scene(Stream& random, const SceneTriangle& triangle, Nearest feature, std::size_t which);

// The names of single edges and vertices after a word: "nearest to edge ab".
inline constexpr std::size_t scenes_of_part = 36;
// Radii of spheres that slide beyond an edge, as exponents of 2: a slack is seen that is larger than the radius.
inline std::array<int, 2> sliding_radii(Precision precision) {
  return precision == Precision::binary32 ? std::array{-6, -7} : std::array{-10, -18};
}
// A slide begins so deep in the triangle.
inline constexpr double slide_depth = 0.125;

}  // namespace slack
}  // namespace axiscert
