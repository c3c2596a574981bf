// Traits of a sphere and a triangle, and those of a triangle that predicates of motions and boxes have too.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "exact/numbers/binary_number.h"
#include "fuzz/queries/capabilities.h"
#include "kernel/base/enums.h"
#include "kernel/base/geometry.h"

namespace axiscert {

const Traits& sphere_triangle_traits();

// The enumerators and the table of a list X(NAME, PHRASE, ...), of the members of Trait.
#define AXISCERT_TRAIT_ENUMERATOR(name, ...) name,
#define AXISCERT_TRAIT_ROW(name, ...) {#name, __VA_ARGS__},

// A set of traits by their enumerators.
template <class Enum>
class TraitBits {
 public:
  void put(Enum which, bool holds = true) { bits_ |= bit_if<TraitSet>(holds, index_of(which)); }
  void put_all(const TraitBits& others) { bits_ |= others.bits_; }
  bool has(Enum which) const { return has_bit(bits_, which); }
  TraitSet bits() const { return bits_; }

 private:
  TraitSet bits_ = 0;
};

using ExactVector = portable::Vec3<BinaryNumber>;
inline ExactVector exact_vector(const portable::Vec3<double>& v) {
  return {BinaryNumber(v.x), BinaryNumber(v.y), BinaryNumber(v.z)};
}
inline BinaryNumber squared_length(const ExactVector& v) { return dot(v, v); }

// A triangle of finite numbers, exactly. Edge i is from corner i to the next.
struct ExactTriangle {
  explicit ExactTriangle(const std::array<portable::Vec3<double>, 3>& corner);

  std::array<portable::Vec3<double>, 3> given;
  std::array<ExactVector, 3> corner, edge;
  std::array<BinaryNumber, 3> squared_edge;
  ExactVector normal;  // AB x AC
  BinaryNumber squared_normal;

  bool is_flat() const { return squared_normal.is_zero(); }
  bool is_obtuse_at(std::size_t i) const;
  bool is_obtuse() const { return is_obtuse_at(0) || is_obtuse_at(1) || is_obtuse_at(2); }
  // With an area, and its least height below a thousandth (2^-10) of its longest edge.
  bool is_thin() const;
  const BinaryNumber& squared_longest() const;
  // With an area, in a plane on which one coordinate is constant.
  bool is_in_plane_of_axes() const;
  // With an edge that is not a point and along which two coordinates are constant.
  bool has_edge_along_axis() const;
};

// Whether all numbers but zeros are below this in magnitude, and one is not zero; whether one of them is at least that.
inline constexpr double small_scene = 1e-3, large_scene = 1e4;
bool is_small_scene(std::span<const double> numbers);
bool is_large_scene(std::span<const double> numbers);
// Whether the origin is at least 64 times as far away, in the maximum norm, as these points are from the first of them.
bool is_far_away(std::span<const portable::Vec3<double>> points, double also = 0);

}  // namespace axiscert
