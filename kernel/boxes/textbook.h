// The textbook's separating axes of two boxes as engines have them: with an epsilon, and axis by axis.
#pragma once

#include <algorithm>

#include "kernel/boxes/axes.h"
#include "kernel/boxes/boxes.h"
#include "kernel/boxes/relative.h"

namespace axiscert::boxes {
// The textbook with an epsilon added to the entries of |R|, "to counteract arithmetic errors when two edges are
// parallel". The epsilons are the published ones: they are part of what is judged, and nothing is proved about them.
// The exact formulae have them as written here; a kernel rounds them to its precision, which `links` calls rounding.

// Rung 5: on all fifteen axes.
template <class T, class Sink>
void textbook_with_epsilon(const BoxPair<T>& q, const T& epsilon, Sink& sink) {
  const Relative<T> r = relative(q);
  const Matrix<T> size = magnitudes(r.turn, &epsilon);
  facets_of_a(r, size, sink);
  facets_of_b(r, r.half_b, size, sink);
  edge_axes(r, size, size, sink);
}

// The book leaves the number open; 2^-23 is the least that its readers take, binary32's own.
// Source: C. Ericson, Real-Time Collision Detection (2005), 4.4.1.
struct Rtcd {
  static constexpr std::string_view name = "rtcd";
  static constexpr FormulaeKind kind = FormulaeKind::variant;
  static constexpr FormulaeKind kind_if_orthonormal = FormulaeKind::variant;
  template <class T, class Sink>
  static void comparisons(const BoxPair<T>& q, Sink& sink) {
    textbook_with_epsilon(q, T(0x1p-23), sink);
  }
};

// The author's own number. Its order, a0 b0 a1 a2 b1 b2 and then the edges, changes the time alone.
// Source: RAPID 2.0 (1997), obb_disjoint; FCL has it still.
struct Gottschalk {
  static constexpr std::string_view name = "gottschalk";
  static constexpr FormulaeKind kind = FormulaeKind::variant;
  static constexpr FormulaeKind kind_if_orthonormal = FormulaeKind::variant;
  template <class T, class Sink>
  static void comparisons(const BoxPair<T>& q, Sink& sink) {
    textbook_with_epsilon(q, T(1e-6), sink);
  }
};

// 1e-5 on the edges alone, which in addition separate only by more than SIMD_EPSILON, here 2^-23 as in a build of
// floats, a length. Facets of B take the distance along b_j in the world, and sums go from left to right. Source:
// Bullet 3.24, dBoxBox2 of btBoxBoxDetector.cpp: the verdict of its axes. What it clips afterwards is not here.
struct Bullet {
  static constexpr std::string_view name = "bullet";
  static constexpr FormulaeKind kind = FormulaeKind::variant;
  static constexpr FormulaeKind kind_if_orthonormal = FormulaeKind::variant;
  template <class T, class Sink>
  static void comparisons(const BoxPair<T>& q, Sink& sink) {
    const T epsilon = T(double{1e-5F}), beyond = T(0x1p-23);
    const Relative<T> r = relative(q);
    const std::array<T, 3>&a = r.half_a, &b = r.half_b;
    const Vec3<T> between = q.b.centre - q.a.centre;
    const Matrix<T> size = magnitudes(r.turn), raised = magnitudes(r.turn, &epsilon);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& row = size[i];
      sink(facet_of_a(i), magnitude(r.along[i]), ((a[i] + b[0] * row[0]) + b[1] * row[1]) + b[2] * row[2]);
    }
    for (std::size_t j = 0; j < 3; ++j) {
      sink(facet_of_b(j), magnitude(dot(q.b.axis[j], between)),
           ((a[0] * size[0][j] + a[1] * size[1][j]) + a[2] * size[2][j]) + b[j]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const auto [i1, i2] = std::minmax({next(i), last(i)});
        const auto [j1, j2] = std::minmax({next(j), last(j)});
        const T apart = edge_sides(r, i, j, raised, raised).lhs;
        const T radii =
            ((a[i1] * raised[i2][j] + a[i2] * raised[i1][j]) + b[j1] * raised[i][j2]) + b[j2] * raised[i][j1];
        sink(edges(i, j), apart - radii, beyond);
      }
    }
  }
};

// The textbook as engines run it: axis by axis, until one separates. Its verdicts are the textbook's; the order and the
// early answer change the time alone.

// The order of RAPID's obb_disjoint: the first facet of each box, the others, then the edges.
struct EarlyTextbook {
  template <class Real>
  static bool separated(const BoxPair<Real>& q) {
    const Relative<Real> r = relative(q);
    const Matrix<Real> size = magnitudes(r.turn);
    const auto by_a = [&](std::size_t i) { return facet_sides_of_a(r, i, size).separate(); };
    const auto by_b = [&](std::size_t j) { return facet_sides_of_b(r, j, r.half_b[j], size).separate(); };
    if (by_a(0) || by_b(0) || by_a(1) || by_a(2) || by_b(1) || by_b(2)) return true;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (edge_sides(r, i, j, size, size).separate()) return true;
      }
    }
    return false;
  }
};

}  // namespace axiscert::boxes
