// Squared distances as quotients of enclosed numbers: to the lines, the plane and the vertices of a triangle, and
// bounds of the distance to the triangle itself. No division, no root; an undecided case gives a wide bound, never a
// wrong one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "exact/numbers/enclosed.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

constexpr std::size_t next_vertex(std::size_t i) { return i == 2 ? 0 : i + 1; }
constexpr std::size_t previous_vertex(std::size_t i) { return i == 0 ? 2 : i - 1; }

// A triangle with the sphere's centre at the origin, scaled by 2^exponent. Edge i runs from vertex i to the next and is
// formed from the given coordinates, not from the vertices here: the edge between two equal vertices is an exact zero.
template <class T>
struct EnclosedTriangle {
  std::array<EnclosedVector<T>, 3> vertex, edge;
  int exponent = 0;
  double scaling_error = 0;  // error of every number after scaling: less than the least double, if any lost bits
};

using DoublePair = DoubleDouble<double>;

// u - v, both within `error` of their exact values.
template <class T>
AXISCERT_INLINE T difference_as(double u, double v) {
  if constexpr (std::is_same_v<T, DoublePair>) {
    const auto difference = arithmetic::two_sum(u, -v);
    return {difference.value, difference.error};
  } else {
    return u - v;
  }
}
template <class T>
AXISCERT_INLINE EnclosedNumber<T> enclosed_difference(double u, double v, double error) {
  const T difference = difference_as<T>(u, v);
  return {difference, (std::is_same_v<T, DoublePair> ? 0 : 0x1p-53 * std::fabs(leading(difference))) + 2 * error};
}

template <class T>
AXISCERT_INLINE EnclosedTriangle<T> enclosed_triangle(const Query<double>& q, double error = 0) {
  const auto difference = [error](const Vec3<double>& u, const Vec3<double>& v) {
    EnclosedVector<T> result = enclosed(
        Vec3<T>{difference_as<T>(u.x, v.x), difference_as<T>(u.y, v.y), difference_as<T>(u.z, v.z)}, 2 * error);
    if (std::is_same_v<T, double>) result.error += 0x1p-53 * result.size;
    return result;
  };
  return {{difference(q.a, q.p), difference(q.b, q.p), difference(q.c, q.p)},
          {difference(q.b, q.a), difference(q.c, q.b), difference(q.a, q.c)},
          0,
          error};
}

// The triangle in double, for binary32 numbers only. They and their differences are multiples of 2^-149 below 2^129;
// the numbers made from them here have degree 6 at most, so each is below 2^800 and, if it is not zero, at least
// 2^-894.
inline EnclosedTriangle<double> enclosed_triangle_of(const Query<float>& q) {
  return enclosed_triangle<double>(widened(q));
}

// The triangle in double-double, for any numbers. They are scaled if the greatest is not within [2^-100, 2^100], so
// that degree 6 stays below 2^650, and 2^-890, the underflow of a product, is negligible. Scaling down may lose bits of
// the small ones.
template <class Real>
EnclosedTriangle<DoublePair> doubled_triangle_of(const Query<Real>& query) {
  Query<double> q = widened(query);
  auto numbers = coordinates(q);
  double greatest = 0;
  for (std::size_t i = 0; i + 1 < numbers.size(); ++i) greatest = std::max(greatest, std::fabs(numbers[i]));
  if ((greatest >= 0x1p-100 && greatest <= 0x1p100) || greatest == 0 || !std::isfinite(greatest)) {
    return enclosed_triangle<DoublePair>(q);
  }
  const int exponent = -std::ilogb(greatest);
  // One product rounds as ldexp would; 2^1074 needs two, both exact.
  const double factor = std::ldexp(1.0, std::min(exponent, 1000)), rest = std::ldexp(1.0, std::max(exponent - 1000, 0));
  for (double& x : numbers) x = x * factor * rest;
  auto triangle = enclosed_triangle<DoublePair>(from_coordinates(numbers), exponent < 0 ? 0x1p-1074 : 0);
  triangle.exponent = exponent;
  return triangle;
}

template <class T>
AXISCERT_INLINE bool is_zero(const EnclosedVector<T>& v) {
  return v.size == 0 && v.error == 0;
}
template <class T>
AXISCERT_INLINE bool has_zero_edge(const EnclosedTriangle<T>& t) {
  return is_zero(t.edge[0]) || is_zero(t.edge[1]) || is_zero(t.edge[2]);
}

// x if it is positive, NaN if it is NaN, else 0.
AXISCERT_INLINE double positive_part(double x) { return x <= 0 ? 0 : x; }

// Bounds of x / y for non-negative numbers, even if the quotient underflows.
AXISCERT_INLINE double quotient_low(double x, double y) { return positive_part(x / y * less - 0x1p-1022); }
AXISCERT_INLINE double quotient_high(double x, double y) { return x / y * more + 0x1p-1022; }

// The square of a distance times the divisor lies in [numerator - below, numerator + above]. Gives no information
// unless the divisor is certainly positive.
template <class T>
struct EnclosedSquare {
  EnclosedNumber<T> numerator, divisor;
  double below = 0, above = 0;
};

// AB x AC, from the two shorter edges: the error is relative to the product of their lengths.
template <class T>
AXISCERT_INLINE EnclosedVector<T> enclosed_normal(const EnclosedTriangle<T>& t) {
  std::size_t longest = t.edge[1].size > t.edge[0].size ? 1 : 0;
  if (t.edge[2].size > t.edge[longest].size) longest = 2;
  return cross(t.edge[next_vertex(longest)], t.edge[previous_vertex(longest)]);
}

// The vertex of edge i, or of the plane, that is nearer to the origin: products with it have the smaller error.
template <class T>
AXISCERT_INLINE std::size_t nearer_vertex(const EnclosedTriangle<T>& t, std::size_t i, std::size_t j) {
  return t.vertex[i].size <= t.vertex[j].size ? i : j;
}

// The square of the distance to the plane: (v . V)^2 / V^2. A triangle without area has the divisor zero.
template <class T>
AXISCERT_INLINE EnclosedSquare<T> plane_square(const EnclosedTriangle<T>& t, const EnclosedVector<T>& normal) {
  const EnclosedNumber<T> height = dot(t.vertex[nearer_vertex(t, nearer_vertex(t, 0, 1), 2)], normal);
  return {height * height, dot(normal, normal)};
}

template <class T>
AXISCERT_INLINE EnclosedSquare<T> vertex_square(const EnclosedTriangle<T>& t, std::size_t i) {
  T one{};
  if constexpr (std::is_same_v<T, DoublePair>) one.high = 1;
  else one = 1;
  return {dot(t.vertex[i], t.vertex[i]), {one, 0}};
}

// The square of the distance to the line through edge i: |v x e|^2 / e^2. An edge between equal vertices has the
// divisor zero.
template <class T>
AXISCERT_INLINE EnclosedSquare<T> line_square(const EnclosedTriangle<T>& t, std::size_t i) {
  const auto moment = cross(t.vertex[nearer_vertex(t, i, next_vertex(i))], t.edge[i]);
  return {dot(moment, moment), dot(t.edge[i], t.edge[i])};
}

// The signed position of the foot on the plane relative to edge i, times |V|^2: positive within the triangle. (v_i x
// v_i+1) . V.
template <class T>
AXISCERT_INLINE EnclosedNumber<T> inward(const EnclosedTriangle<T>& t, std::size_t i, const EnclosedVector<T>& normal) {
  return dot(cross(t.vertex[i], t.edge[i]), normal);
}

}  // namespace axiscert
