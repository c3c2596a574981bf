// The numbers beside a contact of two boxes, or of a box and a triangle, as engines find them: the axis of least
// overlap, and on it a point of each body. Floats alone: lengths are divided by that of the axis.
//
// Measures: the separation, which is minus the overlap; the normal, in which the second body is pushed; a point of the
// first body and one of the second. Nothing is said of bodies apart, whose distance no axis tells.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "kernel/boxes/relative.h"
#include "kernel/boxes/thirteen.h"
#include "kernel/boxes/turned.h"

namespace axiscert::boxes {

// The least overlap found, and the direction from the first body to the second along that axis.
template <class T>
struct LeastAxis {
  std::size_t index = 0;
  T overlap = std::numeric_limits<T>::infinity();
  Vec3<T> normal = {};

  // A NaN is taken by nothing. An axis is preferred to the one before where its overlap times `weight` is less.
  bool take(std::size_t at, T found, T weight) {
    if (!(found * weight < overlap)) return false;
    index = at;
    overlap = found;
    return true;
  }
  bool is_found() const { return overlap < std::numeric_limits<T>::infinity(); }
};

// The first points of a convex polygon, in their order around it. A rectangle that is clipped by four lines has eight.
template <class T>
struct Polygon {
  std::array<Vec3<T>, 9> corner;
  std::size_t size = 0;
  void add(const Vec3<T>& p) {
    if (size < corner.size()) corner[size++] = p;
  }
};

// The point of a polygon, not empty, that is least along d; the first of several.
template <class T>
Vec3<T> lowest(const Polygon<T>& polygon, const Vec3<T>& d) {
  Vec3<T> found = polygon.corner[0];
  for (std::size_t k = 1; k < polygon.size; ++k) {
    if (dot(d, polygon.corner[k]) < dot(d, found)) found = polygon.corner[k];
  }
  return found;
}

// The part of a polygon, not empty, that is not beyond the plane of this normal through `at`; its nearest corner where
// all is, as a rounding can have it.
template <class T>
Polygon<T> clipped(const Polygon<T>& given, const Vec3<T>& out, const Vec3<T>& at) {
  Polygon<T> kept;
  for (std::size_t k = 0; k < given.size; ++k) {
    const Vec3<T>&p = given.corner[k], &q = given.corner[(k + 1) % given.size];
    const T of_p = dot(out, p - at), of_q = dot(out, q - at);
    if (!(of_p > 0)) kept.add(p);
    if ((of_p > 0) != (of_q > 0)) kept.add(p + (q - p) * (of_p / (of_p - of_q)));
  }
  if (kept.size == 0) kept.add(lowest(given, out));
  return kept;
}

// The planes that bound a face on its sides: outwards, and a point of each.
template <class T>
struct Sides {
  struct Side {
    Vec3<T> out, at;
  };
  std::array<Side, 4> side;
  std::size_t size;
};
template <class T>
Polygon<T> within(Polygon<T> polygon, const Sides<T>& sides) {
  for (std::size_t k = 0; k < sides.size; ++k) polygon = clipped(polygon, sides.side[k].out, sides.side[k].at);
  return polygon;
}

// The axis of a box that is most along d.
template <class T>
std::size_t axis_along(const OrientedBox<T>& box, const Vec3<T>& d) {
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (magnitude(dot(d, box.axis[i])) > magnitude(dot(d, box.axis[k]))) k = i;
  }
  return k;
}
// The face that is farthest along d, and its sides.
template <class T>
Polygon<T> face_along(const OrientedBox<T>& box, const Vec3<T>& d) {
  const std::size_t k = axis_along(box, d);
  const T half = dot(d, box.axis[k]) < 0 ? -box.half[k] : box.half[k];
  const Vec3<T> middle = box.centre + box.axis[k] * half, u = box.axis[next(k)] * box.half[next(k)],
                v = box.axis[last(k)] * box.half[last(k)];
  return {{middle + u + v, middle - u + v, middle - u - v, middle + u - v}, 4};
}
// The broader way first: of what a side without breadth cuts, a rounding may leave one corner, which is within the
// others then.
template <class T>
Sides<T> sides_along(const OrientedBox<T>& box, const Vec3<T>& d) {
  Sides<T> found{{}, 4};
  std::size_t at = 0;
  const std::size_t k = axis_along(box, d);
  std::array<std::size_t, 2> along = {next(k), last(k)};
  if (box.half[along[0]] < box.half[along[1]]) std::swap(along[0], along[1]);
  for (const std::size_t i : along) {
    const Vec3<T>& out = box.axis[i];
    found.side[at++] = {out, box.centre + out * box.half[i]};
    found.side[at++] = {out * T(-1), box.centre - out * box.half[i]};
  }
  return found;
}
// The same of a triangle, whose area is not 0.
template <class T>
Polygon<T> face_of(const std::array<Vec3<T>, 3>& corner) {
  return {{corner[0], corner[1], corner[2]}, 3};
}
template <class T>
Sides<T> sides_of(const std::array<Vec3<T>, 3>& corner, const Vec3<T>& normal) {
  Sides<T> found{{}, 3};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<T> out = cross(triangle_edge(corner, k), normal);
    found.side[k] = {dot(out, corner[last(k)] - corner[k]) > 0 ? out * T(-1) : out, corner[k]};
  }
  return found;
}

// The middle of the edge along axis i that is farthest along d.
template <class T>
Vec3<T> edge_along(const OrientedBox<T>& box, std::size_t i, const Vec3<T>& d) {
  Vec3<T> found = box.centre;
  for (const std::size_t k : {next(i), last(i)})
    found = found + box.axis[k] * (dot(d, box.axis[k]) < 0 ? -box.half[k] : box.half[k]);
  return found;
}

template <class T>
struct ContactPoints {
  Vec3<T> a, b;
};

// The lowest point of the face that is met before the face with these sides and this outward normal, and the point of
// the latter there.
template <class T>
struct FacePoints {
  Vec3<T> on_face, on_other;
};
template <class T>
FacePoints<T> points_of_face(const Sides<T>& sides, const Polygon<T>& incident, const Vec3<T>& normal, T overlap) {
  const Vec3<T> deepest = lowest(within(incident, sides), normal);
  return {deepest + normal * overlap, deepest};
}

// That of the three of which the number is least, the first of several; a NaN is the least of nothing.
template <class T, class Number>
ContactPoints<T> least_of(const ContactPoints<T>& one, const ContactPoints<T>& other, const ContactPoints<T>& third,
                          const Number& number) {
  const ContactPoints<T>& best = number(one) <= number(other) ? one : other;
  return number(third) < number(best) ? third : best;
}

// The nearest points of the lines p + s u and q + t v, which are not parallel.
template <class T>
ContactPoints<T> points_of_lines(const Vec3<T>& p, const Vec3<T>& u, const Vec3<T>& q, const Vec3<T>& v) {
  const Vec3<T> between = q - p, across = cross(u, v);
  const T scale = dot(across, across);
  return {p + u * (dot(cross(between, v), across) / scale), q + v * (dot(cross(between, u), across) / scale)};
}

// How far their distance is from the overlap.
template <class T>
T mismatch(const ContactPoints<T>& points, T overlap) {
  const Vec3<T> between = points.a - points.b;
  return magnitude(std::sqrt(dot(between, between)) - overlap);
}

// How far a point is outside of a body, 0 or less within: of a box the greatest along an axis, of a triangle that from
// its plane or from a side of it.
template <class T>
T outside(const OrientedBox<T>& box, const Vec3<T>& p) {
  T most = T(0);
  for (std::size_t k = 0; k < 3; ++k) most = greater(most, magnitude(dot(box.axis[k], p - box.centre)) - box.half[k]);
  return most;
}
template <class T>
T outside(const std::array<Vec3<T>, 3>& corner, const Vec3<T>& normal, const Vec3<T>& p) {
  T most = magnitude(dot(normal, p - corner[0]));
  const Sides<T> sides = sides_of(corner, normal);
  for (std::size_t k = 0; k < sides.size; ++k) {
    const auto& [out, at] = sides.side[k];
    most = greater(most, dot(out, p - at) / std::sqrt(dot(out, out)));
  }
  return most;
}

// NaN in each where there is no contact, or none was found.
template <class T>
void put_contact(bool is_contact, const LeastAxis<T>& least, const ContactPoints<T>& points, T* out) {
  constexpr T unsaid = std::numeric_limits<T>::quiet_NaN();
  const bool says = is_contact && least.is_found();
  const Vec3<T> vectors[] = {least.normal, points.a, points.b};
  // The verdict may be that of other formulae, which hold two for touching that are apart by a rounding here.
  *out++ = says ? T(0) - greater(least.overlap, T(0)) : unsaid;
  for (const Vec3<T>& v : vectors) {
    for (const T x : {v.x, v.y, v.z}) *out++ = says ? x : unsaid;
  }
}

// From A to B.
template <class T>
Vec3<T> facing(const Vec3<T>& axis, const Vec3<T>& between) {
  return dot(axis, between) < 0 ? axis * T(-1) : axis;
}
template <class T>
Vec3<T> unit(const Vec3<T>& v) {
  return v / std::sqrt(dot(v, v));
}

// The least of the fifteen, by the cofactors of R: on an edge axis the overlap is that of the axis which is used, so
// its error stays relative where two edges are nearly parallel. The normal is that same axis, made of entries of R: the
// product of the edges themselves is another one then, or 0.
template <class T>
LeastAxis<T> least_axis(const BoxPair<T>& q, T edge_weight) {
  const Relative<T> r = relative(q);
  const Matrix<T> size = magnitudes(r.turn), minors = magnitudes(cofactors(r.turn));
  const Vec3<T> between = q.b.centre - q.a.centre;
  LeastAxis<T> found;
  const auto facet = [&](std::size_t at, const AxisSides<T>& sides, const Vec3<T>& axis) {
    if (found.take(at, sides.rhs - sides.lhs, T(1))) found.normal = facing(axis, between);
  };
  for (std::size_t i = 0; i < 3; ++i) facet(facet_of_a(i), facet_sides_of_a(r, i, size), q.a.axis[i]);
  for (std::size_t j = 0; j < 3; ++j) facet(facet_of_b(j), facet_sides_of_b(r, j, r.half_b[j], size), q.b.axis[j]);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const T x = r.turn[next(i)][j], y = r.turn[last(i)][j], squared = x * x + y * y;
      const AxisSides<T> sides = edge_sides(r, i, j, size, minors);
      if (!(squared > 0) || !found.take(edges(i, j), (sides.rhs - sides.lhs) / std::sqrt(squared), edge_weight))
        continue;
      found.normal = facing(unit(q.a.axis[last(i)] * x - q.a.axis[next(i)] * y), between);
    }
  }
  return found;
}

// Where an axis of two edges ties with a facet's, the edges are any of a face: of the points that edges and faces give
// those are taken that are least outside of the bodies, and as far apart as they should be.
template <class T>
ContactPoints<T> contact_points(const BoxPair<T>& q, const LeastAxis<T>& least) {
  const Vec3<T>& n = least.normal;
  const Vec3<T> back = n * T(-1);
  const auto by_face_of_a = [&] {
    const auto [on_face, on_other] = points_of_face(sides_along(q.a, n), face_along(q.b, back), n, least.overlap);
    return ContactPoints<T>{on_face, on_other};
  };
  const auto by_face_of_b = [&] {
    const auto [on_face, on_other] = points_of_face(sides_along(q.b, back), face_along(q.a, n), back, least.overlap);
    return ContactPoints<T>{on_other, on_face};
  };
  if (least.index < facet_of_b(0)) return by_face_of_a();
  if (least.index < edges(0, 0)) return by_face_of_b();
  const std::size_t i = (least.index - edges(0, 0)) / 3, j = (least.index - edges(0, 0)) % 3;
  const auto off = [&](const ContactPoints<T>& points) {
    return greater(greater(outside(q.a, points.a), outside(q.b, points.b)), mismatch(points, least.overlap));
  };
  return least_of(points_of_lines(edge_along(q.a, i, n), q.a.axis[i], edge_along(q.b, j, back), q.b.axis[j]),
                  by_face_of_a(), by_face_of_b(), off);
}

// The numbers of two boxes with the verdict of formulae F. `percent` weighs an edge axis: above 100 it has to be less
// than a facet's overlap by so much.
template <class F, int percent = 100>
struct WithContact : F {
  static constexpr std::size_t measure_count = contact_measures;

  template <class T, template <class> class Pair>
  static void measure(const Pair<T>& given, T* out) {
    const BoxPair<T> q = matrices(given);
    const LeastAxis<T> least = least_axis(q, T(percent) / T(100));
    const bool is_contact = bits_of<F, T>(given, [](std::size_t, T, T) {}) == 0;
    put_contact(is_contact, least, contact_points(q, least), out);
  }

 private:
  template <class T>
  static const BoxPair<T>& matrices(const BoxPair<T>& q) {
    return q;
  }
  template <class T, template <class> class Pair>
  static BoxPair<T> matrices(const Pair<T>& q) {
    return with_matrices(q);
  }
};

// The least of the thirteen. Each overlap is that of whole projections in the box's frame, divided by the axis' length.
template <class T>
LeastAxis<T> least_axis(const BoxAndTriangle<T>& q) {
  std::array<Vec3<T>, 3> from;
  for (std::size_t k = 0; k < 3; ++k) from[k] = q.corner[k] - q.box.centre;
  LeastAxis<T> found;
  for (std::size_t i = 0; i < thirteen_count; ++i) {
    const Vec3<T> axis = i < 3 ? q.box.axis[i] : direction(q, i);
    const T squared = dot(axis, axis);
    if (!(squared > 0)) continue;
    const T length = i < 3 ? T(1) : std::sqrt(squared), x = dot(axis, from[0]), y = dot(axis, from[1]),
            z = dot(axis, from[2]), ahead = lesser(lesser(x, y), z), behind = -greater(greater(x, y), z);
    if (!found.take(i, (half_extent(q.box, axis) - greater(ahead, behind)) / length, T(1))) continue;
    const Vec3<T> along = i < 3 ? axis : axis / length;
    found.normal = behind > ahead ? along * T(-1) : along;
  }
  return found;
}

// As of two boxes.
template <class T>
ContactPoints<T> contact_points(const BoxAndTriangle<T>& q, const LeastAxis<T>& least) {
  const Vec3<T>& n = least.normal;
  const Vec3<T> back = n * T(-1);
  const auto by_face_of_box = [&] {
    const auto [on_face, on_other] = points_of_face(sides_along(q.box, n), face_of(q.corner), n, least.overlap);
    return ContactPoints<T>{on_face, on_other};
  };
  const auto by_triangle = [&] {
    const auto [on_face, on_other] = points_of_face(sides_of(q.corner, n), face_along(q.box, n), back, least.overlap);
    return ContactPoints<T>{on_other, on_face};
  };
  if (least.index < plane_axis) return by_face_of_box();
  if (least.index == plane_axis) return by_triangle();
  const std::size_t i = (least.index - edge_axis(0, 0)) / 3, j = (least.index - edge_axis(0, 0)) % 3;
  const ContactPoints<T> lines =
      points_of_lines(edge_along(q.box, i, n), q.box.axis[i], q.corner[j], triangle_edge(q.corner, j));
  const Vec3<T> face = cross(triangle_edge(q.corner, 0), triangle_edge(q.corner, 1));
  if (!(dot(face, face) > 0)) return lines;
  const Vec3<T> normal = unit(face);
  const auto off = [&](const ContactPoints<T>& points) {
    return greater(greater(outside(q.box, points.a), outside(q.corner, normal, points.b)),
                   mismatch(points, least.overlap));
  };
  return least_of(lines, by_face_of_box(), by_triangle(), off);
}

// The numbers of a box and a triangle with the verdict of formulae F.
template <class F>
struct WithTriangleContact : F {
  static constexpr std::size_t measure_count = contact_measures;

  template <class T, template <class> class Problem>
  static void measure(const Problem<T>& given, T* out) {
    const BoxAndTriangle<T> q = oriented(given);
    const LeastAxis<T> least = least_axis(q);
    const bool is_contact = bits_of<F, T>(given, [](std::size_t, T, T) {}) == 0;
    put_contact(is_contact, least, contact_points(q, least), out);
  }
};

}  // namespace axiscert::boxes
