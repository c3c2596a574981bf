// Exact facts about boxes and the axes that part bodies, of which the traits of two boxes and of a box and a triangle
// are made.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "exact/boxes/scaled.h"
#include "fuzz/sphere_triangle/traits.h"
#include "kernel/base/enums.h"

namespace axiscert::boxes::traits {

using Big = BinaryNumber;
using BigBox = OrientedBox<Big>;

// Which axes part two bodies, or on which they are least deep in each other: bit i of axis i.
struct DecidingAxes {
  std::uint32_t parting = 0, least = 0;
};

// On axis i, what is left of the extents beside the distance, times |L|; |L|^2, which is 0 where there is no axis.
struct Rest {
  Big rest, squared_length;
};

template <class RestOf>
DecidingAxes deciding(std::size_t count, const RestOf& rest_of) {
  DecidingAxes found;
  std::optional<Rest> least;
  for (std::size_t i = 0; i < count; ++i) {
    const Rest one = rest_of(i);
    if (one.squared_length.is_zero()) continue;
    if (one.rest.sign() < 0) found.parting |= one_bit<std::uint32_t>(i);
    if (found.parting != 0) continue;
    // rest / |L| of both, by squares.
    const int compared =
        least ? order(one.rest * one.rest * least->squared_length, least->rest * least->rest * one.squared_length) : -1;
    if (compared > 0) continue;
    if (compared < 0) {
      found.least = 0;
      least = one;
    }
    found.least |= one_bit<std::uint32_t>(i);
  }
  if (found.parting != 0) found.least = 0;
  return found;
}

// Whether x is below y / factor, both not negative.
inline bool is_below(const Big& x, const Big& y, double factor) { return x * Big(factor) < y; }

// Cosine above 0.9999 or so: the sine is below a hundredth.
inline bool is_nearly_parallel(const Vec3<Big>& u, const Vec3<Big>& v) {
  const Big product = squared_length(cross(u, v));
  return !product.is_zero() && is_below(product, squared_length(u) * squared_length(v), 1e4);
}
inline bool is_parallel(const Vec3<Big>& u, const Vec3<Big>& v) { return squared_length(cross(u, v)).is_zero(); }

inline Vec3<Big> half_edge(const BigBox& box, std::size_t k) { return box.axis[k] * box.half[k]; }
inline Big squared_size(const BigBox& box) {
  return squared_length(half_edge(box, 0)) + squared_length(half_edge(box, 1)) + squared_length(half_edge(box, 2));
}
inline bool is_flat(const BigBox& box) {
  return std::ranges::any_of(box.half, [](const Big& half) { return half.is_zero(); });
}
// With its shortest edge above 0 and below a thousandth of its longest.
inline bool is_thin(const BigBox& box) {
  std::array<Big, 3> squares;
  for (std::size_t k = 0; k < 3; ++k) squares[k] = squared_length(half_edge(box, k));
  std::ranges::sort(squares, [](const Big& x, const Big& y) { return x < y; });
  return !squares[0].is_zero() && is_below(squares[0], squares[2], 1e6);
}
inline bool is_inside(const Vec3<Big>& point, const BigBox& box) {
  const Vec3<Big> from = point - box.centre;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<Big> normal = facet_normal(box, k);
    if (box.half[k] * magnitude(dot(box.axis[k], normal)) < magnitude(dot(from, normal))) return false;
  }
  return true;
}
// Each axis along one of the world's.
inline bool is_level(const BigBox& box) {
  return std::ranges::all_of(
      box.axis, [](const Vec3<Big>& axis) { return axis.x.is_zero() + axis.y.is_zero() + axis.z.is_zero() == 2; });
}

template <class Entry>
auto given_of(const std::vector<double>& numbers) {
  return Entry::template problem<double>([&](std::size_t k) { return numbers[k]; });
}

}  // namespace axiscert::boxes::traits
