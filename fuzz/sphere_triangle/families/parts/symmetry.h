// The symmetries of the predicate: transformations that leave every exact answer unchanged, except for the names of
// vertices.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Vertex i of the image is vertex vertices[i] of the original, and its coordinate i is the original's coordinate
// axes[i], negated if bit i of `signs` is set.
struct Symmetry {
  std::array<std::uint8_t, 3> vertices, axes;
  std::uint8_t signs;
};
// Six vertex orders times 48 permutations and reflections of the axes; the first is the identity.
std::span<const Symmetry> symmetries();
inline constexpr std::size_t symmetry_count = 288;

// The image of a query over any numbers that have a minus.
template <class T>
Query<T> image(const Query<T>& q, const Symmetry& symmetry) {
  const auto mapped = [&](const Vec3<T>& v) {
    const std::array<const T*, 3> from = {&v.x, &v.y, &v.z};
    std::array<T, 3> to;
    for (std::size_t i = 0; i < 3; ++i) {
      const T& x = *from[symmetry.axes[i]];
      to[i] = has_bit(symmetry.signs, i) ? T(-x) : x;
    }
    return Vec3<T>{to[0], to[1], to[2]};
  };
  const std::array<const Vec3<T>*, 3> vertex = {&q.a, &q.b, &q.c};
  const auto at = [&](std::size_t i) { return mapped(*vertex[symmetry.vertices[i]]); };
  return {at(0), at(1), at(2), mapped(q.p), q.r};
}

}  // namespace axiscert
