// Building blocks shared by several families: vertices, integers, feet on features, radii. Plain arithmetic in Real in
// a fixed order, so that the values are the same everywhere; for the same reason no expression reads the stream twice.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "fuzz/queries/random.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::shapes {
// A, B, C. Edge i runs from vertex i to vertex i + 1; vertex i + 2 lies opposite.
template <class Real>
using Vertices = std::array<Vec3<Real>, 3>;
constexpr std::size_t next(std::size_t vertex) { return (vertex + 1) % 3; }
constexpr std::size_t opposite(std::size_t edge) { return (edge + 2) % 3; }

// Uniform in the cube [-1, 1)^3, full significands.
template <class Real>
Vec3<Real> in_cube(Stream& random) {
  const Real x = random.symmetric<Real>(), y = random.symmetric<Real>(), z = random.symmetric<Real>();
  return {x, y, z};
}
template <class Real>
Vertices<Real> vertices_in_cube(Stream& random) {
  const Vec3<Real> a = in_cube<Real>(random), b = in_cube<Real>(random), c = in_cube<Real>(random);
  return {a, b, c};
}

// Integers in [-bound, bound], never all zero.
template <class Integer = std::int64_t>
Vec3<Integer> integers(Stream& random, std::int64_t bound) {
  const auto x = static_cast<Integer>(random.integer(-bound, bound));
  const auto y = static_cast<Integer>(random.integer(-bound, bound));
  const auto z = static_cast<Integer>(random.integer(-bound, bound));
  if (x == 0 && y == 0 && z == 0) return {1, 0, 0};
  return {x, y, z};
}

// Weights of the three vertices, with sum `parts`, that put a point on the axis's feature: the face, the vertex, the
// edge.
std::array<std::int64_t, 3> weights(Stream& random, Axis axis, std::int64_t parts);

// One of the six orders, all equally likely.
template <class Real>
Vertices<Real> shuffled(Stream& random, Vertices<Real> vertices) {
  const auto first = static_cast<std::size_t>(random.below(3));
  std::swap(vertices[0], vertices[first]);
  if (random.coin()) std::swap(vertices[1], vertices[2]);
  return vertices;
}

template <class Real>
Query<Real> query(const Vertices<Real>& vertices, const Vec3<Real>& p, Real r = 0) {
  return {vertices[0], vertices[1], vertices[2], p, r};
}

// Every coordinate times 2^exponent, which has to be a number of the precision: each product is rounded once.
template <class Real>
Vec3<Real> scaled(const Vec3<Real>& v, int exponent);

// A radius at the exact distance rounded to nearest, or up to `ulps` floats from it.
template <class Real>
Real radius_near_distance(Stream& random, const Query<Real>& q, int ulps);

// Families in lanes make their queries in blocks of at most this many: first the vertices and centres, in lanes, then,
// one by one, whatever is solved with exact arithmetic, from two numbers that the lanes leave for each query.
inline constexpr std::size_t block_size = 64;
template <class Real>
using Wishes = std::array<std::array<Real, block_size>, 2>;

// Sets radii to the exact distance, stepped by the first wish in ulps and multiplied by the second. If the second is 0
// the radius remains as it is.
template <class Real>
void solve_aimed_radii(const MutableColumns<Real>& queries, const Wishes<Real>& wishes);

}  // namespace axiscert::shapes

namespace axiscert {
// The queries of family `tie`, for families that are built from them.

// Integers that touch exactly, on the feature of axis `position` modulo axis_count; below 2^24 (2^53).
template <class Real>
Query<Real> touching_integers(Stream& random, std::uint64_t position);

}  // namespace axiscert
