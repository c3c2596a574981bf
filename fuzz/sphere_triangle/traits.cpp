#include "fuzz/sphere_triangle/traits.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/base/enums.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

ExactTriangle::ExactTriangle(const std::array<portable::Vec3<double>, 3>& of) : given(of) {
  for (std::size_t i = 0; i < 3; ++i) corner[i] = exact_vector(of[i]);
  for (std::size_t i = 0; i < 3; ++i) {
    edge[i] = corner[(i + 1) % 3] - corner[i];
    squared_edge[i] = squared_length(edge[i]);
  }
  normal = cross(edge[0], corner[2] - corner[0]);
  squared_normal = squared_length(normal);
}

bool ExactTriangle::is_obtuse_at(std::size_t i) const { return dot(edge[i], edge[(i + 2) % 3]).sign() > 0; }

const BinaryNumber& ExactTriangle::squared_longest() const {
  return *std::max_element(squared_edge.begin(), squared_edge.end(),
                           [](const BinaryNumber& x, const BinaryNumber& y) { return x < y; });
}

bool ExactTriangle::is_thin() const {
  // The height over the longest edge is |n| / edge^2.
  const BinaryNumber& longest = squared_longest();
  return !is_flat() && squared_normal * BinaryNumber(0x1p20) < longest * longest;
}

bool ExactTriangle::is_in_plane_of_axes() const {
  const auto& [a, b, c] = given;
  return !is_flat() && ((a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y) || (a.z == b.z && b.z == c.z));
}

bool ExactTriangle::has_edge_along_axis() const {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &u = given[i], &v = given[(i + 1) % 3];
    if ((u.x == v.x) + (u.y == v.y) + (u.z == v.z) == 2) return true;
  }
  return false;
}

bool is_small_scene(std::span<const double> numbers) {
  return std::ranges::any_of(numbers, [](double x) { return x != 0; }) &&
         std::ranges::all_of(numbers, [](double x) { return std::abs(x) < small_scene; });
}

bool is_large_scene(std::span<const double> numbers) {
  return std::ranges::any_of(numbers, [](double x) { return std::abs(x) >= large_scene; });
}

bool is_far_away(std::span<const portable::Vec3<double>> points, double also) {
  // Differences are exact, so that a threshold is one.
  BinaryNumber extent(std::abs(also)), greatest;
  const auto raise = [](BinaryNumber& to, BinaryNumber by) {
    by = magnitude(by);
    if (to < by) to = std::move(by);
  };
  const auto parts = [](const portable::Vec3<double>& v) { return std::array{v.x, v.y, v.z}; };
  const std::array<double, 3> first = parts(points.front());
  for (const auto& point : points) {
    const std::array<double, 3> at = parts(point);
    for (std::size_t k = 0; k < 3; ++k) {
      raise(extent, BinaryNumber(at[k]) - BinaryNumber(first[k]));
      raise(greatest, BinaryNumber(at[k]));
    }
  }
  return !greatest.is_zero() && greatest >= extent * BinaryNumber(64.0);
}

namespace {

#define AXISCERT_SPHERE_TRAITS(X)                                                 \
  X(face, "nearest to the face", "regions")                                       \
  X(edge, "nearest to an edge", "regions")                                        \
  X(vertex, "nearest to a vertex", "regions")                                     \
  X(edge_ab, "nearest to edge ab", "regions")                                     \
  X(edge_bc, "nearest to edge bc", "regions")                                     \
  X(edge_ca, "nearest to edge ca", "regions")                                     \
  X(vertex_a, "nearest to vertex a", "regions")                                   \
  X(vertex_b, "nearest to vertex b", "regions")                                   \
  X(vertex_c, "nearest to vertex c", "regions")                                   \
  X(off_ab, "that do not meet the line of edge ab", {}, true, true)               \
  X(off_bc, "that do not meet the line of edge bc", {}, true, true)               \
  X(off_ca, "that do not meet the line of edge ca", {}, true, true)               \
  X(on_triangle, "with the centre on the triangle", "on_triangle")                \
  X(in_plane, "with the centre in the triangle's plane, beside it")               \
  X(just_outside, "with the centre over a strip of 1 % beside the triangle")      \
  X(closely_outside, "with the centre over a strip of 0.1 % beside the triangle") \
  X(just_inside, "with the centre over a strip of 1 % within the triangle")       \
  X(front, "with the centre in front")                                            \
  X(behind, "with the centre behind")                                             \
  X(obtuse_there, "with an obtuse corner there", "obtuse")                        \
  X(obtuse, "of an obtuse triangle", "obtuse")                                    \
  X(acute, "of a triangle without an obtuse corner")                              \
  X(obtuse_a, "of a triangle obtuse at a", "obtuse")                              \
  X(obtuse_b, "of a triangle obtuse at b", "obtuse")                              \
  X(obtuse_c, "of a triangle obtuse at c", "obtuse")                              \
  X(flat, "of a triangle without area", "flat")                                   \
  X(thin, "of a triangle less than a thousandth as high as long")                 \
  X(axis_plane, "of a triangle in a plane x, y or z = constant", "aligned")       \
  X(axis_edge, "of a triangle with an edge along an axis", "aligned")             \
  X(zero_radius, "of radius 0")                                                   \
  X(large_sphere, "with a radius above the longest edge")                         \
  X(small_sphere, "with a radius below a hundredth of the longest edge")          \
  X(small, "with all numbers below 1e-3")                                         \
  X(large, "with a number of 1e4 or more")                                        \
  X(far, "with the origin 64 times as far away as the scene is long")

enum class SphereTrait : std::uint8_t { AXISCERT_SPHERE_TRAITS(AXISCERT_TRAIT_ENUMERATOR) };
constexpr Trait sphere_traits[] = {AXISCERT_SPHERE_TRAITS(AXISCERT_TRAIT_ROW)};
static_assert(std::size(sphere_traits) <= most_traits);

SphereTrait of_corner(SphereTrait first, std::size_t i) { return static_cast<SphereTrait>(index_of(first) + i); }

// A squared distance as a quotient; the denominator is positive.
struct Squared {
  BinaryNumber over, under;
  friend int order(const Squared& x, const Squared& y) { return order(x.over * y.under, y.over * x.under); }
};

// The parts of the triangle that are nearest to the centre, at which the corners are seen as `to`.
void put_nearest(TraitBits<SphereTrait>& found, const ExactTriangle& triangle, const std::array<ExactVector, 3>& to,
                 const std::array<BinaryNumber, 3>& sides) {
  using enum SphereTrait;
  if (!triangle.is_flat() && std::ranges::all_of(sides, [](const BinaryNumber& side) { return side.sign() > 0; })) {
    found.put(face);
    found.put(on_triangle, dot(to[0], triangle.normal).is_zero());
    return;
  }
  std::optional<Squared> least;
  TraitBits<SphereTrait> nearest;
  const auto add = [&](const Squared& squared, SphereTrait part, SphereTrait kind) {
    const int compared = least ? order(squared, *least) : -1;
    if (compared > 0) return;
    if (compared < 0) {
      least = squared;
      nearest = {};
    }
    nearest.put(part);
    nearest.put(kind);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const BinaryNumber squared = squared_length(to[i]);
    add({squared, BinaryNumber::one()}, of_corner(vertex_a, i), vertex);
    const BinaryNumber foot = -dot(to[i], triangle.edge[i]);
    const BinaryNumber& length = triangle.squared_edge[i];
    if (foot.sign() > 0 && foot < length) add({squared * length - foot * foot, length}, of_corner(edge_ab, i), edge);
  }
  found.put_all(nearest);
  found.put(on_triangle, least->over.is_zero());
  for (std::size_t i = 0; i < 3; ++i)
    found.put(obtuse_there, nearest.has(of_corner(vertex_a, i)) && triangle.is_obtuse_at(i));
}

TraitSet traits_of(const std::vector<double>& numbers, std::size_t) {
  using enum SphereTrait;
  std::array<double, coordinate_count> given{};
  std::ranges::copy(numbers, given.begin());
  const Query<double> q = from_coordinates(given);
  const ExactTriangle triangle({q.a, q.b, q.c});
  const ExactVector p = exact_vector(q.p);
  std::array<ExactVector, 3> to;
  std::array<BinaryNumber, 3> sides;  // the areas of the three parts of the triangle at the foot, times |n|
  for (std::size_t i = 0; i < 3; ++i) to[i] = triangle.corner[i] - p;
  for (std::size_t i = 0; i < 3; ++i) sides[i] = dot(cross(to[i], to[(i + 1) % 3]), triangle.normal);
  TraitBits<SphereTrait> found;
  put_nearest(found, triangle, to, sides);

  const int offset = -dot(to[0], triangle.normal).sign();
  found.put(front, offset > 0);
  found.put(behind, offset < 0);
  found.put(in_plane, offset == 0 && !triangle.is_flat() && !found.has(on_triangle));
  if (!triangle.is_flat()) {
    const BinaryNumber hundred(100.0);
    const BinaryNumber least = *std::ranges::min_element(sides, [](const auto& x, const auto& y) { return x < y; });
    const bool is_near = magnitude(least) * hundred < triangle.squared_normal;
    found.put(just_outside, is_near && least.sign() < 0);
    found.put(closely_outside, least.sign() < 0 && magnitude(least) * BinaryNumber(1000.0) < triangle.squared_normal);
    found.put(just_inside, is_near && least.sign() > 0);
  }

  const BinaryNumber r(q.r), squared_radius = r * r;
  for (std::size_t i = 0; i < 3; ++i)
    found.put(of_corner(off_ab, i),
              squared_radius * triangle.squared_edge[i] < squared_length(cross(to[i], triangle.edge[i])));
  for (std::size_t i = 0; i < 3; ++i) found.put(of_corner(obtuse_a, i), triangle.is_obtuse_at(i));
  found.put(obtuse, triangle.is_obtuse());
  found.put(acute, !triangle.is_obtuse());
  found.put(flat, triangle.is_flat());
  found.put(thin, triangle.is_thin());
  found.put(axis_plane, triangle.is_in_plane_of_axes());
  found.put(axis_edge, triangle.has_edge_along_axis());

  found.put(zero_radius, q.r == 0);
  found.put(large_sphere, squared_radius > triangle.squared_longest());
  found.put(small_sphere, squared_radius * BinaryNumber(1e4) < triangle.squared_longest());
  found.put(small, is_small_scene(numbers));
  found.put(large, is_large_scene(numbers));
  const std::array points = {q.p, q.a, q.b, q.c};
  found.put(far, is_far_away(points, q.r));
  return found.bits();
}

}  // namespace

const Traits& sphere_triangle_traits() {
  static constexpr Traits traits = {"spheres", sphere_traits, traits_of};
  return traits;
}

}  // namespace axiscert
