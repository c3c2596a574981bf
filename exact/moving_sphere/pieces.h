// The squared distance of a moving centre from a triangle as a function of time, piece by piece, in integers.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "exact/moving_sphere/given_motion.h"
#include "exact/numbers/rational.h"
#include "kernel/base/enum_set.h"

namespace axiscert::moving_sphere {

// A part of the triangle that can be nearest to the centre.
enum class Feature : std::uint8_t { vertex_a, vertex_b, vertex_c, edge_ab, edge_bc, edge_ca, face };

}  // namespace axiscert::moving_sphere

namespace axiscert {
template <>
inline constexpr std::size_t enum_count<moving_sphere::Feature> = 7;
}  // namespace axiscert

namespace axiscert::moving_sphere {

inline constexpr EnumArray<Feature, std::string_view> feature_names = {"vertex_a", "vertex_b", "vertex_c", "edge_ab",
                                                                       "edge_bc",  "edge_ca",  "face"};
using FeatureSet = EnumSet<Feature, std::uint8_t>;

// value + slope t; a gate is open where it is not negative.
struct Gate {
  mpz_class value, slope;
};

// The times in [0, 1] at which one feature is nearest: where all of its gates are open, from `first` to `last`, which
// may be equal. There the squared distance is (a t^2 - 2 b t + c) / divisor in squares of the motion's unit. If a is 0,
// so is b; the divisor is positive.
struct Piece {
  Feature feature;
  std::vector<Gate> gates;
  Rational first, last;
  mpz_class a, b, c, divisor;
};

// A query of finite numbers, any triangle and any D; `r` is not read. Lengths are integers times 2^exponent.
//
// The pieces cover [0, 1] together, since a triangle's Voronoi regions are bounded by planes, and those that share a
// time have the same distance at it. They are sorted by `first`.
struct MotionPieces {
  explicit MotionPieces(const GivenMotion& q);

  std::array<portable::Vec3<mpz_class>, 3> vertex;  // seen from P
  portable::Vec3<mpz_class> d, normal;              // D, and AB x AC, zero for a triangle without area
  int exponent;
  std::vector<Piece> pieces;
};

Rational quotient(const mpz_class& numerator, const mpz_class& denominator);
// q 2^exponent.
Rational scaled(const Rational& q, int exponent);

}  // namespace axiscert::moving_sphere
