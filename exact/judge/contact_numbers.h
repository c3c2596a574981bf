// Numbers beside a verdict as exact ones, and how far vectors and parts of a triangle are from what is right.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "exact/judge/contact_judgement.h"
#include "exact/numbers/rational.h"
#include "kernel/base/geometry.h"

namespace axiscert {

using RationalVector = portable::Vec3<Rational>;

// Three measures from the first one on; empty where they are not all given and finite.
std::optional<RationalVector> vector_at(std::span<const double> measures, std::size_t first);

// Each the nearest of binary64; v / |v| of a v that is not zero.
std::array<double, 3> rounded(const RationalVector& v);
std::array<double, 3> unit_vector(const RationalVector& v);

// The angle between two vectors in radians, rounded to the nearest binary64 from its sine; pi where one is zero.
double angle_between(const RationalVector& a, const RationalVector& b);
// A push along a normal of length 0: all of the depth is left.
inline Pushed pushed_nowhere() { return {.left = round_up(1), .is_nowhere = true}; }
// | |n| - 1 |, of binary64; at most the greatest.
double length_error(const RationalVector& n);

// |s^ - s| for a given s^, where s = sqrt(squared) - r and the scene's extent is a root too, not 0. `Real` is the
// precision of the kernel.
template <class Real>
SeparationError separation_error(double given, const Rational& squared, const Rational& r,
                                 const Rational& squared_scene);

// Parts of a triangle by number: 0, 1, 2 the vertices, 3, 4, 5 the edges ab, bc, ca, 6 the face.
inline constexpr std::size_t triangle_parts = 7;
// The part that a number names; empty where it names none.
std::optional<std::size_t> part_named(double number);
// The square of the greatest distance of the centre from a plane that bounds the region of a part and has the centre on
// its other side; 0 where there is no such plane.
Rational squared_beyond(std::size_t part, const std::array<RationalVector, 3>& vertices, const RationalVector& centre);

}  // namespace axiscert
