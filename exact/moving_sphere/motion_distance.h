// The distance of a moving centre from a triangle: as a function of time, its least, and that of the path by CGAL.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "exact/numbers/rational.h"
#include "kernel/base/enums.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert::moving_sphere {
// A motion in either entry of the predicate, the numbers as they were given. `to` is the displacement D, or the end P1
// of the motion, whose displacement P1 - P is exact here though no number may be it.
struct GivenMotion {
  portable::Vec3<double> a, b, c, p, to;
  bool to_is_end;
  double r;

  GivenMotion(const MovingQuery<double>& q) : a(q.a), b(q.b), c(q.c), p(q.p), to(q.d), to_is_end(false), r(q.r) {}
  GivenMotion(const EndsQuery<double>& q) : a(q.a), b(q.b), c(q.c), p(q.p), to(q.p1), to_is_end(true), r(q.r) {}

  // D in the exact numbers T that `exactly(x)` makes of a double.
  template <class T, class Exactly>
  portable::Vec3<T> displacement(Exactly&& exactly) const {
    const auto vector = [&](const portable::Vec3<double>& v) {
      return portable::Vec3<T>{exactly(v.x), exactly(v.y), exactly(v.z)};
    };
    if (to_is_end) return vector(to) - vector(p);
    return vector(to);
  }
};

}  // namespace axiscert::moving_sphere

// The squared distance of a moving centre from a triangle as a function of time, piece by piece, in integers.

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

// The least distance of a moving centre from a triangle, in integers and rationals, without a root. It shares nothing
// with the twenty axes or with CGAL.

struct LeastDistance {
  Rational squared;       // the least over t in [0, 1] of |P + t D - X|^2, X in the closed triangle ABC
  bool crosses_the_face;  // the centre passes through the plane of ABC strictly inside ABC, strictly between 0 and 1
};

// For every query of finite numbers, any triangle and any D; `r` is not read.
//
// The squared distance is, over t, one quadratic a t^2 - 2 b t + c on each interval in which the nearest feature is the
// same. A feature's interval is where linear functions of t, its gates, are not negative; the intervals cover [0, 1]
// together, since a triangle's Voronoi regions are bounded by planes. So the least is at an end of such an interval or
// at b / a in it, all of which are rational.
LeastDistance least_distance(const GivenMotion& q);

// The exact distance of the centre's path from the triangle, by CGAL.

// The squared distance of the triangles ABC and (P, P + D, P + D): the second is the path, as CGAL 5.5 has no distance
// of a segment from a triangle. For every query of finite numbers; `r` is not read.
Rational swept_squared_distance(const GivenMotion& q);

// The sign of the same less r^2, of the motion as far as P + until D; `until` is any finite number. The radius is not
// negative. The motion's first contact is at t* or before exactly where this is not positive for until = t*.
int swept_distance_order(const GivenMotion& q, double until = 1);

}  // namespace axiscert::moving_sphere
