// Squared distances as quotients of enclosed numbers: to the lines, the plane and the vertices of a triangle, and
// bounds of the distance to the triangle itself. No division, no root; what cannot be told is a wide bound, never a
// wrong one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "exact/enclosed.h"
#include "kernel/query.h"

namespace axiscert {

constexpr std::size_t next_vertex(std::size_t i) { return i == 2 ? 0 : i + 1; }
constexpr std::size_t previous_vertex(std::size_t i) { return i == 0 ? 2 : i - 1; }

// A triangle with the sphere's centre at the origin, all of it times 2^exponent. Edge i runs from vertex i to the next,
// formed from the given coordinates and not from the vertices here: that of two equal vertices is an exact zero.
template <class T>
struct EnclosedTriangle {
  std::array<Vec3<Enclosed<T>>, 3> vertex, edge;
  int exponent = 0;
  double scaling_error = 0;  // of every number once scaled: less than the least double, where one lost bits
};

using Doubled = DoubleDouble<double>;

// u - v, both within `error` of what they stand for.
template <class T>
AXISCERT_INLINE Enclosed<T> enclosed_difference(double u, double v, double error) {
  if constexpr (std::is_same_v<T, Doubled>) {
    const auto difference = arithmetic::two_sum(u, -v);
    return {{difference.value, difference.error}, 2 * error};
  } else {
    const double difference = u - v;
    return {difference, sum_error(u, v, difference) + 2 * error};
  }
}

template <class T>
AXISCERT_INLINE EnclosedTriangle<T> enclosed_triangle(const Query<double>& q, double error = 0) {
  const auto difference = [error](const Vec3<double>& u, const Vec3<double>& v) {
    return Vec3<Enclosed<T>>{enclosed_difference<T>(u.x, v.x, error), enclosed_difference<T>(u.y, v.y, error),
                             enclosed_difference<T>(u.z, v.z, error)};
  };
  return {{difference(q.a, q.p), difference(q.b, q.p), difference(q.c, q.p)},
          {difference(q.b, q.a), difference(q.c, q.b), difference(q.a, q.c)},
          0,
          error};
}

// In double: of binary32 numbers only. They and their differences are multiples of 2^-149 below 2^129; what is made of
// them here has degree 6 at most, so it is below 2^800 and, where it is not zero, at least 2^-894.
inline EnclosedTriangle<double> enclosed_triangle_of(const Query<float>& q) {
  return enclosed_triangle<double>(widened(q));
}

// In double-double: of any numbers. They are scaled where the greatest is not within [2^-100, 2^100], so that degree 6
// stays below 2^650, and 2^-890, the underflow of a product, is far below what matters. Scaling down may lose bits of
// the small ones.
template <class Real>
EnclosedTriangle<Doubled> doubled_triangle_of(const Query<Real>& query) {
  Query<double> q = widened(query);
  auto numbers = coordinates(q);
  double greatest = 0;
  for (std::size_t i = 0; i + 1 < numbers.size(); ++i) greatest = std::max(greatest, std::fabs(numbers[i]));
  if ((greatest >= 0x1p-100 && greatest <= 0x1p100) || greatest == 0 || !std::isfinite(greatest)) {
    return enclosed_triangle<Doubled>(q);
  }
  const int exponent = -std::ilogb(greatest);
  for (double& x : numbers) x = std::ldexp(x, exponent);
  auto triangle = enclosed_triangle<Doubled>(from_coordinates(numbers), exponent < 0 ? 0x1p-1074 : 0);
  triangle.exponent = exponent;
  return triangle;
}

template <class T>
AXISCERT_INLINE Vec3<Enclosed<double>> as_doubles(const Vec3<Enclosed<T>>& v) {
  return {as_double(v.x), as_double(v.y), as_double(v.z)};
}
template <class T>
AXISCERT_INLINE Vec3<double> leading(const Vec3<Enclosed<T>>& v) {
  return {leading(v.x.value), leading(v.y.value), leading(v.z.value)};
}
// x where it is positive, and a NaN where it is one.
AXISCERT_INLINE double positive_part(double x) { return x <= 0 ? 0 : x; }

// Of numbers that are not negative: x / y bounded, whatever of the quotient underflows.
AXISCERT_INLINE double quotient_low(double x, double y) { return positive_part(x / y * less - 0x1p-1022); }
AXISCERT_INLINE double quotient_high(double x, double y) { return x / y * more + 0x1p-1022; }

// The square of a distance times the divisor lies in [numerator - below, numerator + above]. Says nothing unless the
// divisor is certainly positive.
template <class T>
struct EnclosedSquare {
  Enclosed<T> numerator, divisor;
  double below = 0, above = 0;
};

// AB x AC, from the two shorter edges: the error is relative to the product of their lengths.
template <class T>
AXISCERT_INLINE Vec3<Enclosed<T>> enclosed_normal(const EnclosedTriangle<T>& t) {
  double length2[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<double> edge = leading(t.edge[i]);
    length2[i] = dot(edge, edge);
  }
  std::size_t longest = length2[1] > length2[0] ? 1 : 0;
  if (length2[2] > length2[longest]) longest = 2;
  return cross(t.edge[next_vertex(longest)], t.edge[previous_vertex(longest)]);
}

// The vertex of edge i, or of the plane, that is nearer to the origin: products with it err least.
template <class T>
AXISCERT_INLINE std::size_t nearer_vertex(const EnclosedTriangle<T>& t, std::size_t i, std::size_t j) {
  const Vec3<double> u = leading(t.vertex[i]), v = leading(t.vertex[j]);
  return dot(u, u) <= dot(v, v) ? i : j;
}

// To the plane: (v . V)^2 / V^2. A triangle without area has the divisor zero.
template <class T>
AXISCERT_INLINE EnclosedSquare<T> plane_square(const EnclosedTriangle<T>& t, const Vec3<Enclosed<T>>& normal) {
  const Enclosed<T> height = dot(t.vertex[nearer_vertex(t, nearer_vertex(t, 0, 1), 2)], normal);
  return {height * height, dot(normal, normal)};
}

template <class T>
AXISCERT_INLINE EnclosedSquare<T> vertex_square(const EnclosedTriangle<T>& t, std::size_t i) {
  T one{};
  if constexpr (std::is_same_v<T, Doubled>) one.high = 1;
  else one = 1;
  return {dot(t.vertex[i], t.vertex[i]), {one, 0}};
}

// To the line through edge i: |v x e|^2 / e^2. An edge between equal vertices has the divisor zero.
template <class T>
AXISCERT_INLINE EnclosedSquare<T> line_square(const EnclosedTriangle<T>& t, std::size_t i) {
  const auto moment = cross(t.vertex[nearer_vertex(t, i, next_vertex(i))], t.edge[i]);
  return {dot(moment, moment), dot(t.edge[i], t.edge[i])};
}

// Where the plane's foot lies to edge i, times |V|^2: positive within the triangle. (v_i x v_i+1) . V.
template <class T>
AXISCERT_INLINE Enclosed<T> inward(const EnclosedTriangle<T>& t, std::size_t i, const Vec3<Enclosed<T>>& normal) {
  return dot(cross(t.vertex[i], t.edge[i]), normal);
}

// The feature that seems nearest: 0 the plane, 1 + i vertex i, 4 + i edge i, as the axes are numbered. Nothing below
// relies on it.
template <class T>
std::size_t likely_feature(const EnclosedTriangle<T>& t, const Vec3<Enclosed<T>>& enclosed_normal) {
  const Vec3<double> normal = leading(enclosed_normal);
  std::array<Vec3<double>, 3> moment;
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    moment[i] = cross(leading(t.vertex[i]), leading(t.edge[i]));
    inside = inside && dot(moment[i], normal) >= 0;
  }
  if (inside && as_double(dot(as_doubles(enclosed_normal), as_doubles(enclosed_normal))).low() > 0) return 0;
  std::size_t feature = 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<double> v = leading(t.vertex[i]), edge = leading(t.edge[i]);
    const double along = -dot(v, edge), length2 = dot(edge, edge);
    const std::size_t end = along <= 0 ? i : along >= length2 ? next_vertex(i) : 3;
    const Vec3<double> to = end < 3 ? leading(t.vertex[end]) : moment[i];
    const double square = end < 3 ? dot(to, to) : dot(to, to) / length2;
    if (square < least) {
      least = square;
      feature = end < 3 ? 1 + end : 4 + i;
    }
  }
  return feature;
}

// The distance to the triangle, from that to the plane of a feature, its line or itself, and by how much the feature
// could fail to be the nearest. Certain for any triangle and any feature; narrow for the right one.
//
// face    d is at least that to the plane. The foot has the barycentric coordinates w_i = inward_i / V^2. Let n be the
// sum
//         of the negative ones, unsigned; moving them to zero and dividing by 1 + n gives a point of the triangle that
//         is n |x - y| from the foot for two points x, y of the triangle, so d^2 <= h^2 + n^2 L^2, L the longest edge.
// edge    With c the foot on the line, c.x over the triangle is least at an end of the edge, c^2, or at the third
// vertex,
//         c^2 - m / e^2 with m = inward: so d >= (c^2 - max(0, m) / e^2) / |c|, and d^2 e^2 >= c^2 e^2 - 2 max(0, m).
//         Where v_i . e > 0 the foot lies before vertex i: |v_i|^2 e^2 = c^2 e^2 + (v_i . e)^2; so at the other end.
// vertex  d <= |v|, and d >= min over the vertices x of v.x / |v|: d^2 >= v^2 - 2 max(0, -v.(x - v)).
template <class T>
EnclosedSquare<T> face_bounds(const EnclosedTriangle<T>& t, const Vec3<Enclosed<T>>& normal) {
  EnclosedSquare<T> square = plane_square(t, normal);
  const Vec3<Enclosed<double>> direction = as_doubles(normal);
  double outside = 0, longest2 = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<Enclosed<double>> edge = as_doubles(t.edge[i]);
    outside += positive_part(-dot(cross(as_doubles(t.vertex[i]), edge), direction).low());
    longest2 = std::max(longest2, dot(edge, edge).high());
  }
  if (outside == 0) return square;
  // n is rounded up to 2^-300 at least, so that neither n nor n L is lost to underflow; where the whole is, 2^-1022
  // makes up for it.
  const Enclosed<double> divisor = as_double(square.divisor);
  const double n = outside / divisor.low() * more + 0x1p-300;
  const double span = n * std::sqrt(longest2) * more;
  square.above = span * span * divisor.high() * more + 0x1p-1022;
  return square;
}

template <class T>
EnclosedSquare<T> edge_bounds(const EnclosedTriangle<T>& t, std::size_t i, const Vec3<Enclosed<T>>& normal) {
  EnclosedSquare<T> square = line_square(t, i);
  const Vec3<Enclosed<double>> edge = as_doubles(t.edge[i]), v = as_doubles(t.vertex[i]);
  if (!(dot(cross(v, edge), as_doubles(normal)).high() <= 0)) {
    square.below = 2 * positive_part(inward(t, i, normal).high());
  }
  const double before = positive_part(dot(v, edge).high());
  const double beyond = positive_part(-dot(as_doubles(t.vertex[next_vertex(i)]), edge).low());
  if (!(before == 0 && beyond == 0)) square.above = (before * before + beyond * beyond) * more + 0x1p-1022;
  return square;
}

template <class T>
EnclosedSquare<T> vertex_bounds(const EnclosedTriangle<T>& t, std::size_t i) {
  EnclosedSquare<T> square = vertex_square(t, i);
  const auto& v = t.vertex[i];
  const auto &to_next = t.edge[i], &from_previous = t.edge[previous_vertex(i)];
  double nearer = 0;
  if (!(dot(as_doubles(v), as_doubles(to_next)).low() >= 0)) nearer += positive_part(-dot(v, to_next).low());
  if (!(dot(as_doubles(v), as_doubles(from_previous)).high() <= 0)) {
    nearer += positive_part(dot(v, from_previous).high());
  }
  square.below = 2 * nearer;
  return square;
}

// How wide the bounds are, for choosing among them; infinite where nothing bounds the distance.
template <class T>
double relative_width(const EnclosedSquare<T>& square) {
  const bool bounded = as_double(square.divisor).low() > 0 && leading(square.numerator.value) > 0;
  return bounded ? (square.below + square.above) / leading(square.numerator.value) : HUGE_VAL;
}

// Where the likely feature may not be the nearest, being so near to the border of its region that doubles do not tell,
// that beyond the border is tried as well: the plane for an edge, an edge for a vertex.
template <class T>
EnclosedSquare<T> distance_bounds(const EnclosedTriangle<T>& t) {
  const Vec3<Enclosed<T>> normal = enclosed_normal(t);
  std::size_t feature = likely_feature(t, normal);
  if (feature == 0) return face_bounds(t, normal);
  EnclosedSquare<T> best{};
  if (feature < 4) {
    const std::size_t i = feature - 1;
    best = vertex_bounds(t, i);
    if (best.below == 0) return best;
    const auto &v = t.vertex[i], &to_next = t.edge[i], &from_previous = t.edge[previous_vertex(i)];
    feature = 4 + (-leading(dot(v, to_next).value) > leading(dot(v, from_previous).value) ? i : previous_vertex(i));
    const EnclosedSquare<T> other = edge_bounds(t, feature - 4, normal);
    if (relative_width(other) < relative_width(best)) best = other;
  } else {
    best = edge_bounds(t, feature - 4, normal);
  }
  if (best.below == 0) return best;
  const EnclosedSquare<T> other = face_bounds(t, normal);
  return relative_width(other) < relative_width(best) ? other : best;
}

}  // namespace axiscert
