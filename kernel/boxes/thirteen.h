// The thirteen axes of a box and a triangle: the box's three normals, the triangle's, and the nine products of an edge
// of each. An axis is one comparison, max(min p, -max p) > the box's half extent, p the corners' distances from the
// box's centre along it.
#pragma once

#include "kernel/boxes/axes.h"
#include "kernel/boxes/box_triangle.h"

namespace axiscert::boxes {

// x: the normal of the box's facets along its first axis; x_ab: at right angles to that axis and the edge ab.
inline constexpr std::array<std::string_view, 13> thirteen_names = {
    "x", "y", "z", "plane", "x_ab", "x_bc", "x_ca", "y_ab", "y_bc", "y_ca", "z_ab", "z_bc", "z_ca"};
inline constexpr std::size_t thirteen_count = thirteen_names.size(), plane_axis = 3;
constexpr std::size_t edge_axis(std::size_t i, std::size_t j) { return 4 + 3 * i + j; }

template <class T>
Vec3<T> triangle_edge(const std::array<Vec3<T>, 3>& corner, std::size_t j) {
  return corner[next(j)] - corner[j];
}

// The axis of comparison i as a vector; it is 0 for parallel edges, and without an area of the triangle for `plane`.
template <class T>
Vec3<T> direction(const BoxAndTriangle<T>& q, std::size_t i) {
  if (i < 3) return facet_normal(q.box, i);
  if (i == plane_axis) return cross(triangle_edge(q.corner, 0), q.corner[2] - q.corner[0]);
  return cross(q.box.axis[(i - 4) / 3], triangle_edge(q.corner, (i - 4) % 3));
}

// Products of the box's own vectors and whole projections. Over the reals right for every box of independent axes and
// every triangle. Degree 3 > 4; of a box along the world's axes 1 > 1, 2 > 2 and 3 > 3 in lengths.
struct Thirteen {
  static constexpr std::string_view name = "thirteen";
  static constexpr FormulaeKind kind = FormulaeKind::rung;

  template <class T, class Problem, class Sink>
  static void comparisons(const Problem& given, Sink& sink) {
    const BoxAndTriangle<T> q = oriented(given);
    const std::array<Vec3<T>, 3> from_centre = {q.corner[0] - q.box.centre, q.corner[1] - q.box.centre,
                                                q.corner[2] - q.box.centre};
    for (std::size_t i = 0; i < thirteen_count; ++i) {
      const Vec3<T> along = direction(q, i);
      sink(i, beyond_zero(dot(along, from_centre[0]), dot(along, from_centre[1]), dot(along, from_centre[2])),
           half_extent(q.box, along));
    }
  }
};

// The comparisons of a triangle in the box's own frame, without the terms that are 0: the two ends of an edge have one
// distance along a product with it, so two corners are asked.
template <class T, class Sink>
void framed_thirteen(const std::array<T, 3>& half, const std::array<Vec3<T>, 3>& v, Sink& sink) {
  const auto component = [](const Vec3<T>& p, std::size_t k) -> const T& { return k == 0 ? p.x : k == 1 ? p.y : p.z; };
  for (std::size_t k = 0; k < 3; ++k) {
    sink(k, beyond_zero(component(v[0], k), component(v[1], k), component(v[2], k)), half[k]);
  }
  const std::array<Vec3<T>, 3> edge = {v[1] - v[0], v[2] - v[1], v[0] - v[2]};
  const Vec3<T> normal = cross(edge[0], edge[1]);
  sink(plane_axis, magnitude(dot(normal, v[0])),
       (half[0] * magnitude(normal.x) + half[1] * magnitude(normal.y)) + half[2] * magnitude(normal.z));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t i1 = next(i), i2 = last(i);
    for (std::size_t j = 0; j < 3; ++j) {
      const T &e1 = component(edge[j], i1), &e2 = component(edge[j], i2);
      const auto along = [&](const Vec3<T>& p) { return e1 * component(p, i2) - e2 * component(p, i1); };
      const T p = along(v[j]), q = along(v[last(j)]);
      sink(edge_axis(i, j), greater(lesser(p, q), T(0.0) - greater(p, q)),
           half[i1] * magnitude(e2) + half[i2] * magnitude(e1));
    }
  }
}

// As books have it, of a box along the axes: right over the reals. Degrees 1 > 1, 3 > 3 for the plane, 2 > 2.
// Source: C. Ericson, Real-Time Collision Detection (2005), 5.2.9.
struct TextbookThirteen {
  static constexpr std::string_view name = "textbook";
  static constexpr FormulaeKind kind = FormulaeKind::rung;

  template <class T, class Problem, class Sink>
  static void comparisons(const Problem& given, Sink& sink) {
    const CentredAndTriangle<T> q = centred(given);
    framed_thirteen<T>(q.half, {{q.corner[0] - q.centre, q.corner[1] - q.centre, q.corner[2] - q.centre}}, sink);
  }
};

// The same in the frame of an oriented box: right over the reals where its axes are orthonormal.
struct FramedThirteen {
  static constexpr std::string_view name = "textbook";
  static constexpr FormulaeKind kind = FormulaeKind::variant;

  template <class T, class Sink>
  static void comparisons(const BoxAndTriangle<T>& q, Sink& sink) {
    std::array<Vec3<T>, 3> framed;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3<T> from = q.corner[k] - q.box.centre;
      framed[k] = {dot(q.box.axis[0], from), dot(q.box.axis[1], from), dot(q.box.axis[2], from)};
    }
    framed_thirteen<T>(q.box.half, framed, sink);
  }
};

// The same of a quaternion, whose rotation is orthonormal over the reals: what is lost is the kernel's rounding of its
// matrix.
struct TurnedThirteen {
  static constexpr std::string_view name = FramedThirteen::name;
  static constexpr FormulaeKind kind = FormulaeKind::rung;

  template <class T, class Sink>
  static void comparisons(const TurnedAndTriangle<T>& q, Sink& sink) {
    FramedThirteen::comparisons<T>(oriented(q), sink);
  }
};

}  // namespace axiscert::boxes
