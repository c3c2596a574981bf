// The thirteen axes of an oriented box and a triangle, as formulae: no test of the harness asks them yet.
#pragma once

#include "kernel/boxes/axes.h"

namespace axiscert::boxes {

// A box, and the triangle of three corners, which may be degenerate.
template <class T>
struct BoxAndTriangle {
  OrientedBox<T> box;
  std::array<Vec3<T>, 3> corner;
};

// The box's three normals, the triangle's, and the nine products of edges; max(min p, -max p) > the half extent, p the
// corners' distances from the box's centre. Over the reals right for every box of independent axes and every triangle.
// Degree 3 > 4.
struct Thirteen {
  static constexpr std::size_t count = 13, plane = 3;
  static constexpr std::size_t edges_of(std::size_t i, std::size_t j) { return 4 + 3 * i + j; }

  template <class T, class Sink>
  static void comparisons(const BoxAndTriangle<T>& q, Sink& sink) {
    const std::array<Vec3<T>, 3> from_centre = {q.corner[0] - q.box.centre, q.corner[1] - q.box.centre,
                                                q.corner[2] - q.box.centre};
    const auto edge = [&](std::size_t k) { return q.corner[next(k)] - q.corner[k]; };
    const auto axis = [&](std::size_t i, const Vec3<T>& along) {
      sink(i, beyond_zero(dot(along, from_centre[0]), dot(along, from_centre[1]), dot(along, from_centre[2])),
           half_extent(q.box, along));
    };
    for (std::size_t k = 0; k < 3; ++k) axis(k, facet_normal(q.box, k));
    axis(plane, cross(edge(0), q.corner[2] - q.corner[0]));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) axis(edges_of(i, j), cross(q.box.axis[i], edge(j)));
    }
  }
};

}  // namespace axiscert::boxes
