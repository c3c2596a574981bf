// The two slips of the article's text, kept as kernels: each is wrong in exact arithmetic.
#pragma once

#include "kernel/sphere_triangle/formulae.h"

namespace axiscert::rungs {

// The first publication had `QC = C e + Q` for `QC = C e - Q` (a reader's comment reports it), in all three edge axes.
struct FirstPublication {
  static constexpr bool is_ring = true;
  template <class T, class Emit>
  AXISCERT_INLINE static void comparisons(const portable::Problem<T>& q, Emit&& emit) {
    using enum Comparison;
    const auto centred = portable::centred(q);
    const auto& [A, B, C, rr] = centred;
    const auto misprinted_side = [&](const auto& from, const auto& to, const auto& opposite) {
      const auto along = to - from;
      const T d = dot(from, to) - dot(from, from), e = dot(along, along);
      const auto Q = from * e - along * d;
      return dot(Q, opposite * e + Q);
    };
    portable::published_comparisons(centred, q.zero, [&](Comparison which, const T& lhs, const T& rhs) {
      if (which == edge_ab_side_c) emit(which, misprinted_side(A, B, C), q.zero);
      else if (which == edge_bc_side_a) emit(which, misprinted_side(B, C, A), q.zero);
      else if (which == edge_ca_side_b) emit(which, misprinted_side(C, A, B), q.zero);
      else emit(which, lhs, rhs);
    });
  }
};

// The vertex section has `ac = dot(B, B)` and no `bb`. This is the test of a reader who adds the missing line and keeps
// the other.
struct VertexTypo {
  static constexpr bool is_ring = true;
  template <class T, class Emit>
  AXISCERT_INLINE static void comparisons(const portable::Problem<T>& q, Emit&& emit) {
    using enum Comparison;
    const auto centred = portable::centred(q);
    const T ac = dot(centred.b, centred.b);
    portable::published_comparisons(centred, q.zero, [&](Comparison which, const T& lhs, const T& rhs) {
      emit(which, which == vertex_a_side_c || which == vertex_c_side_a ? ac : lhs, rhs);
    });
  }
};

}  // namespace axiscert::rungs
