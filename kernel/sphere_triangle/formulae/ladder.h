// The article's derivation, step by step: each axis in every form that it passes through, and the complete tests that
// these make, from the one in which nothing is rewritten (Ladder0) to the published one (Ladder9).
//
// Source: C. Ericson, "Optimizing a sphere-triangle intersection test" (2010), the blocks of pseudocode in their order.
// The early forms have `/` and `sqrt`; over the reals every form has the signs of the published one wherever it is
// defined. It is undefined (0/0) for the plane of a zero-area triangle and for the line of a repeated vertex, where the
// published comparisons are 0 > 0: neither ever separates.
#pragma once

#include "kernel/sphere_triangle/formulae.h"

namespace axiscert::rungs {

using portable::CentredProblem, portable::Problem, portable::Vec3, portable::magnitude, portable::square_root,
    portable::times_square;

// |A.N| > r with N = V/|V|   ->   (A.V/|V|)^2 > rr   ->   (A.V)^2/(V.V) > rr   ->   (A.V)^2 > rr (V.V).
enum class PlaneForm { normalised, squared, divided, cross_multiplied };
// sqrt(A.A) > r, (B - A).A > 0   ->   A.A > rr, A.B > A.A.
enum class VertexForm { rooted, distributed };
// Q = A + (d/e) AB, |Q - P| > r   ->   squared   ->   both sides times e^2   ->   Q e = A e + d AB, no division   ->
// centred, d = A.AB   ->   d = A.B - A.A.
enum class EdgeForm { rooted, squared, scaled, undivided, centred, distributed };

template <PlaneForm form, class T, class Emit>
AXISCERT_INLINE void plane(const CentredProblem<T>& centred, const T& r, Emit&& emit) {
  using enum PlaneForm;
  const Vec3<T>& A = centred.a;
  const Vec3<T> V = cross(centred.b - A, centred.c - A);
  if constexpr (form == normalised) {
    const Vec3<T> N = V / square_root(dot(V, V));
    emit(Comparison::plane_radius, magnitude(dot(A, N)), r);
  } else if constexpr (form == squared) {
    const T d = dot(A, V) / square_root(dot(V, V));
    emit(Comparison::plane_radius, d * d, centred.rr);
  } else {
    const T d = dot(A, V), e = dot(V, V);
    if constexpr (form == divided) emit(Comparison::plane_radius, (d * d) / e, centred.rr);
    else emit(Comparison::plane_radius, d * d, centred.rr * e);
  }
}

// The three comparisons of the axis through vertex A, in their order; B and C are the other two vertices.
template <VertexForm form, class T, class Emit>
AXISCERT_INLINE void vertex(const Vec3<T>& A, const Vec3<T>& B, const Vec3<T>& C, const T& r, const T& rr,
                            const T& zero, Comparison radius, Emit&& emit) {
  const auto side_b = static_cast<Comparison>(static_cast<int>(radius) + 1);
  const auto side_c = static_cast<Comparison>(static_cast<int>(radius) + 2);
  const T aa = dot(A, A);
  if constexpr (form == VertexForm::rooted) {
    emit(radius, square_root(aa), r);
    emit(side_b, dot(B - A, A), zero);
    emit(side_c, dot(C - A, A), zero);
  } else {
    emit(radius, aa, rr);
    emit(side_b, dot(A, B), aa);
    emit(side_c, dot(A, C), aa);
  }
}

// The two comparisons of the axis of edge AB; C is the opposite vertex. All three are centred.
template <EdgeForm form, class T, class Emit>
AXISCERT_INLINE void centred_edge(const Vec3<T>& A, const Vec3<T>& B, const Vec3<T>& C, const T& rr, const T& zero,
                                  Comparison radius, Emit&& emit) {
  const auto side = static_cast<Comparison>(static_cast<int>(radius) + 1);
  const Vec3<T> AB = B - A;
  const T d = form == EdgeForm::centred ? dot(A, AB) : dot(A, B) - dot(A, A), e = dot(AB, AB);
  const Vec3<T> Q = A * e - AB * d;
  const Vec3<T> QC = C * e - Q;
  emit(radius, dot(Q, Q), times_square(rr, e));
  emit(side, dot(Q, QC), zero);
}

// The two comparisons before the derivation moves the centre P to the origin, from the vertices as given.
template <EdgeForm form, class T, class Emit>
AXISCERT_INLINE void uncentred_edge(const Vec3<T>& A, const Vec3<T>& B, const Vec3<T>& C, const Vec3<T>& P, const T& r,
                                    const T& rr, const T& zero, Comparison radius, Emit&& emit) {
  using enum EdgeForm;
  const auto side = static_cast<Comparison>(static_cast<int>(radius) + 1);
  const Vec3<T> AB = B - A;
  const T d = dot(P - A, AB), e = dot(AB, AB);
  if constexpr (form == undivided) {
    const Vec3<T> Q = A * e + AB * d;
    const Vec3<T> QP = P * e - Q, QC = C * e - Q;
    emit(radius, dot(QP, QP), times_square(rr, e));
    emit(side, zero, dot(QP, QC));
    return;
  } else {
    const Vec3<T> Q = A + AB * (d / e);
    const Vec3<T> QP = P - Q, QC = C - Q;
    if constexpr (form == scaled) {
      const Vec3<T> scaled_QP = QP * e;
      emit(radius, dot(scaled_QP, scaled_QP), times_square(rr, e));
      emit(side, zero, dot(scaled_QP, QC * e));
    } else {
      if constexpr (form == rooted) emit(radius, square_root(dot(QP, QP)), r);
      else emit(radius, dot(QP, QP), rr);
      emit(side, zero, dot(QP, QC));
    }
  }
}

// A complete test: one form for each kind of axis. Emits all sixteen comparisons, in their order.
template <PlaneForm plane_form, VertexForm vertex_form, EdgeForm edge_form>
struct Rung {
  static constexpr bool is_ring =
      plane_form == PlaneForm::cross_multiplied && vertex_form == VertexForm::distributed &&
      (edge_form == EdgeForm::undivided || edge_form == EdgeForm::centred || edge_form == EdgeForm::distributed);

  template <class T, class Emit>
  AXISCERT_INLINE static void comparisons(const Problem<T>& q, Emit&& emit) {
    using enum Comparison;
    const CentredProblem<T> centred = portable::centred(q);
    const auto& [A, B, C, rr] = centred;
    plane<plane_form>(centred, q.r, emit);
    vertex<vertex_form>(A, B, C, q.r, rr, q.zero, vertex_a_radius, emit);
    vertex<vertex_form>(B, A, C, q.r, rr, q.zero, vertex_b_radius, emit);
    vertex<vertex_form>(C, A, B, q.r, rr, q.zero, vertex_c_radius, emit);
    if constexpr (edge_form == EdgeForm::centred || edge_form == EdgeForm::distributed) {
      centred_edge<edge_form>(A, B, C, rr, q.zero, edge_ab_radius, emit);
      centred_edge<edge_form>(B, C, A, rr, q.zero, edge_bc_radius, emit);
      centred_edge<edge_form>(C, A, B, rr, q.zero, edge_ca_radius, emit);
    } else {
      uncentred_edge<edge_form>(q.a, q.b, q.c, q.p, q.r, rr, q.zero, edge_ab_radius, emit);
      uncentred_edge<edge_form>(q.b, q.c, q.a, q.p, q.r, rr, q.zero, edge_bc_radius, emit);
      uncentred_edge<edge_form>(q.c, q.a, q.b, q.p, q.r, rr, q.zero, edge_ca_radius, emit);
    }
  }
};

// Each step makes one rewriting, in the article's order: the plane, the vertices, the edges.
using Ladder0 = Rung<PlaneForm::normalised, VertexForm::rooted, EdgeForm::rooted>;
using Ladder1 = Rung<PlaneForm::squared, VertexForm::rooted, EdgeForm::rooted>;
using Ladder2 = Rung<PlaneForm::divided, VertexForm::rooted, EdgeForm::rooted>;
using Ladder3 = Rung<PlaneForm::cross_multiplied, VertexForm::rooted, EdgeForm::rooted>;
using Ladder4 = Rung<PlaneForm::cross_multiplied, VertexForm::distributed, EdgeForm::rooted>;
using Ladder5 = Rung<PlaneForm::cross_multiplied, VertexForm::distributed, EdgeForm::squared>;
using Ladder6 = Rung<PlaneForm::cross_multiplied, VertexForm::distributed, EdgeForm::scaled>;
using Ladder7 = Rung<PlaneForm::cross_multiplied, VertexForm::distributed, EdgeForm::undivided>;
using Ladder8 = Rung<PlaneForm::cross_multiplied, VertexForm::distributed, EdgeForm::centred>;
using Ladder9 = Rung<PlaneForm::cross_multiplied, VertexForm::distributed, EdgeForm::distributed>;

}  // namespace axiscert::rungs
