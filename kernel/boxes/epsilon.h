// The textbook with an epsilon added to the entries of |R|, as engines have it "to counteract arithmetic errors when
// two edges are parallel". The epsilons are the published ones: they are part of what is judged, and nothing is proved
// about them.
#pragma once

#include "kernel/boxes/relative.h"

namespace axiscert::boxes {

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

// 1e-5 on the edges alone, which in addition separate only by more than 2^-23, a length.
// Source: Bullet 3.24, dBoxBox2 of btBoxBoxDetector.cpp: the verdict of its axes. What it clips afterwards is not here.
struct Bullet {
  static constexpr std::string_view name = "bullet";
  static constexpr FormulaeKind kind = FormulaeKind::variant;
  static constexpr FormulaeKind kind_if_orthonormal = FormulaeKind::variant;
  template <class T, class Sink>
  static void comparisons(const BoxPair<T>& q, Sink& sink) {
    const T epsilon = T(1e-5), beyond = T(0x1p-23);
    const Relative<T> r = relative(q);
    const Matrix<T> size = magnitudes(r.turn), raised = magnitudes(r.turn, &epsilon);
    facets_of_a(r, size, sink);
    facets_of_b(r, r.half_b, size, sink);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const EdgeSides<T> sides = edge_sides(r, i, j, raised, raised);
        sink(edges(i, j), sides.lhs - sides.rhs, beyond);
      }
    }
  }
};

}  // namespace axiscert::boxes
