// The first three rungs of the predicate of two boxes, in the world's axes: by definition, and with each of the two
// steps that need orthogonal columns. docs/boxes.md has the table of the rungs.
#pragma once

#include "kernel/boxes/axes.h"

namespace axiscert::boxes {

// Rung 0. |T.L| > the sum of both half extents in direction L, T from centre to centre and L one of the fifteen.
//
// Over the reals right for every pair of boxes of independent axes, zero extents included: the directions are products
// of the boxes' own vectors, and all six terms are there. Degree 3 > 4. Parallel edges: L = 0 and 0 > 0, never
// separates.
struct ProjectedFifteen {
  static constexpr std::string_view name = "projected";
  static constexpr FormulaeKind kind = FormulaeKind::rung;
  static constexpr FormulaeKind kind_if_orthonormal = FormulaeKind::rung;

  template <class T, class Sink>
  constexpr static void comparisons(const BoxPair<T>& q, Sink& sink) {
    const Vec3<T> between = q.b.centre - q.a.centre;
    for (std::size_t i = 0; i < axis_count; ++i) {
      const Vec3<T> along = direction(q, i);
      sink(i, magnitude(dot(along, between)), half_extent(q.a, along) + half_extent(q.b, along));
    }
  }
};

// Rung 1. A facet's normal is the third column instead of a product: right for orthogonal columns of any length. Degree
// 2 > 3 for the facets.
struct Columns {
  static constexpr std::string_view name = "columns";
  static constexpr FormulaeKind kind = FormulaeKind::variant;
  static constexpr FormulaeKind kind_if_orthonormal = FormulaeKind::rung;

  template <class T, class Sink>
  constexpr static void comparisons(const BoxPair<T>& q, Sink& sink) {
    const Vec3<T> between = q.b.centre - q.a.centre;
    for (std::size_t i = 0; i < axis_count; ++i) {
      const Vec3<T> along = i < 3 ? q.a.axis[i] : i < 6 ? q.b.axis[i - 3] : direction(q, i);
      sink(i, magnitude(dot(along, between)), half_extent(q.a, along) + half_extent(q.b, along));
    }
  }
};

// Rung 2. Terms that are 0 over the reals are left out: a box's other two axes along its own column, and the two edges
// along their product. A computed product is not exactly at right angles to them, so of two edges that are nearly
// parallel it can be an axis that separates nothing, and deep contacts are missed.
struct DroppedFifteen {
  static constexpr std::string_view name = "dropped";
  static constexpr FormulaeKind kind = FormulaeKind::variant;
  static constexpr FormulaeKind kind_if_orthonormal = FormulaeKind::rung;

  template <class T, class Sink>
  constexpr static void comparisons(const BoxPair<T>& q, Sink& sink) {
    const Vec3<T> between = q.b.centre - q.a.centre;
    const auto facets = [&](const OrientedBox<T>& own, const OrientedBox<T>& other, std::size_t first) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3<T>& along = own.axis[k];
        sink(first + k, magnitude(dot(along, between)), own.half[k] * dot(along, along) + half_extent(other, along));
      }
    };
    facets(q.a, q.b, facet_of_a(0));
    facets(q.b, q.a, facet_of_b(0));
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Vec3<T> along = cross(q.a.axis[i], q.b.axis[j]);
        sink(edges(i, j), magnitude(dot(along, between)), without(q.a, i, along) + without(q.b, j, along));
      }
    }
  }

 private:
  template <class T>
  constexpr static T without(const OrientedBox<T>& box, std::size_t edge, const Vec3<T>& along) {
    const auto term = [&](std::size_t k) { return box.half[k] * magnitude(dot(along, box.axis[k])); };
    return term(next(edge)) + term(last(edge));
  }
};

}  // namespace axiscert::boxes
