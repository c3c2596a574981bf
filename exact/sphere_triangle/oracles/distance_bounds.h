// Bounds of the distance from the origin to a triangle, in enclosed numbers. An undecided case gives a wide bound,
// never a wrong one.
#pragma once

#include "exact/sphere_triangle/oracles/nearest_feature.h"

namespace axiscert {

// The distance to the triangle, from the distance to the feature's plane, line or vertex and a bound on how far the
// feature could be from being the nearest. Certain for any triangle and any feature; narrow for the right one.
//
// face    d is at least the distance to the plane. The foot has the barycentric coordinates inward_i / V^2. Let n be
//         the sum of the negative ones, unsigned; moving them to zero and dividing by 1 + n gives a point of the
//         triangle that is n |x - y| from the foot for two points x, y of the triangle: d^2 <= h^2 + n^2 L^2, L the
//         longest edge.
// edge    With c the foot on the line, c.x is least over the triangle at an end of the edge, c^2, or at the third
//         vertex, c^2 - m / e^2, m = inward: d >= (c^2 - max(0, m) / e^2) / |c|, and d^2 e^2 >= c^2 e^2 - 2 max(0, m).
//         Where v_i . e > 0 the foot lies before vertex i: |v_i|^2 e^2 = c^2 e^2 + (v_i . e)^2; likewise at the other
//         end.
// vertex  d <= |v|, and d >= min over the vertices x of v.x / |v|: d^2 >= v^2 - 2 max(0, -v.(x - v)).
template <class T>
EnclosedSquare<T> face_bounds(const EnclosedTriangle<T>& t, const EnclosedVector<T>& normal) {
  EnclosedSquare<T> square = plane_square(t, normal);
  const EnclosedVector<double> direction = as_doubles(normal);
  double outside = 0, longest2 = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const EnclosedVector<double> edge = as_doubles(t.edge[i]);
    outside += positive_part(-dot(cross(as_doubles(t.vertex[i]), edge), direction).low());
    longest2 = std::max(longest2, dot(edge, edge).high());
  }
  if (outside == 0) return square;
  // n is rounded up to 2^-300 at least, so that neither n nor n L is lost to underflow; if their product underflows,
  // 2^-1022 makes up for it.
  const EnclosedNumber<double> divisor = as_double(square.divisor);
  const double n = outside / divisor.low() * more + 0x1p-300;
  const double span = n * std::sqrt(longest2) * more;
  square.above = span * span * divisor.high() * more + 0x1p-1022;
  return square;
}

template <class T>
EnclosedSquare<T> edge_bounds(const EnclosedTriangle<T>& t, std::size_t i, const EnclosedVector<T>& normal) {
  EnclosedSquare<T> square = line_square(t, i);
  const EnclosedVector<double> edge = as_doubles(t.edge[i]), v = as_doubles(t.vertex[i]);
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

// The relative width of the bounds, for choosing among them; infinite if nothing bounds the distance.
template <class T>
double relative_width(const EnclosedSquare<T>& square) {
  const bool bounded = as_double(square.divisor).low() > 0 && leading(square.numerator.value) > 0;
  return bounded ? (square.below + square.above) / leading(square.numerator.value) : HUGE_VAL;
}

// The likely feature may not be the nearest if it is so near to the border of its region that doubles do not decide.
// Then the feature beyond the border is tried as well: the plane for an edge, an edge for a vertex.
template <class T>
EnclosedSquare<T> bounds_near_a_border(const EnclosedTriangle<T>& t) {
  const EnclosedVector<T> normal = enclosed_normal(t);
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

// The square of the distance to the closed triangle, degenerate or not.
template <class T>
EnclosedSquare<T> distance_bounds(const EnclosedTriangle<T>& t) {
  const std::size_t feature = certain_feature(t);
  if (feature == 0) return plane_square(t, enclosed_normal(t));
  if (feature < 4) return vertex_square(t, feature - 1);
  if (feature < unclear_feature) return line_square(t, feature - 4);
  return bounds_near_a_border(t);
}

}  // namespace axiscert
