// The article's derivation, step by step: each axis in every form that it passes through, and the complete tests that
// these make, from the one in which nothing is rewritten (Ladder0) to the published one (Ladder9).
//
// Source: C. Ericson, "Optimizing a sphere-triangle intersection test" (2010), the blocks of pseudocode in their order.
// The early forms have `/` and `sqrt`; over the reals every form has the signs of the published one wherever it is
// defined. It is undefined (0/0) for the plane of a zero-area triangle and for the line of a repeated vertex, where the
// published comparisons are 0 > 0: neither ever separates.
#pragma once

#include "kernel/sphere_triangle/forms/edges.h"

namespace axiscert::rungs {

using portable::CentredProblem, portable::Problem, portable::magnitude;

// |A.N| > r with N = V/|V|   ->   (A.V/|V|)^2 > rr   ->   (A.V)^2/(V.V) > rr   ->   (A.V)^2 > rr (V.V).
// The last two with lengths for squares, which are no steps of the article: |A.V|/|V| > r and |A.V| > r |V|.
enum class PlaneForm { normalised, squared, divided, cross_multiplied, divided_rooted, multiplied_rooted };
// sqrt(A.A) > r, (B - A).A > 0   ->   A.A > rr, A.B > A.A.
enum class VertexForm { rooted, distributed };

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
    else if constexpr (form == cross_multiplied) emit(Comparison::plane_radius, d * d, centred.rr * e);
    else if constexpr (form == divided_rooted) emit(Comparison::plane_radius, magnitude(d) / square_root(e), r);
    else emit(Comparison::plane_radius, magnitude(d), r * square_root(e));
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

// A complete test: one form for each kind of axis. Emits all sixteen comparisons, in their order.
template <PlaneForm plane_form_, VertexForm vertex_form_, class Edge_>
struct Rung {
  static constexpr PlaneForm plane_form = plane_form_;
  static constexpr VertexForm vertex_form = vertex_form_;
  using Edge = Edge_;
  static constexpr bool is_ring =
      plane_form == PlaneForm::cross_multiplied && vertex_form == VertexForm::distributed && Edge::is_ring;

  template <class T, class Emit>
  AXISCERT_INLINE static void comparisons(const Problem<T>& q, Emit&& emit) {
    using enum Comparison;
    const CentredProblem<T> centred = portable::centred(q);
    const auto& [A, B, C, rr] = centred;
    plane<plane_form>(centred, q.r, emit);
    vertex<vertex_form>(A, B, C, q.r, rr, q.zero, vertex_a_radius, emit);
    vertex<vertex_form>(B, A, C, q.r, rr, q.zero, vertex_b_radius, emit);
    vertex<vertex_form>(C, A, B, q.r, rr, q.zero, vertex_c_radius, emit);
    if constexpr (Edge::frame == Frame::centred) edges(A, B, C, q, rr, emit);
    else edges(q.a, q.b, q.c, q, rr, emit);
  }

 private:
  template <class T, class Emit>
  AXISCERT_INLINE static void edges(const Vec3<T>& A, const Vec3<T>& B, const Vec3<T>& C, const Problem<T>& q,
                                    const T& rr, Emit&& emit) {
    const Vec3<T> V = Edge::takes_normal ? cross(B - A, C - A) : Vec3<T>{q.zero, q.zero, q.zero};
    const EdgeProblem<T> edge{q.p, V, q.r, rr, q.zero};
    Edge::comparisons(A, B, C, edge, Comparison::edge_ab_radius, emit);
    Edge::comparisons(B, C, A, edge, Comparison::edge_bc_radius, emit);
    Edge::comparisons(C, A, B, edge, Comparison::edge_ca_radius, emit);
  }
};

// The plane and the vertices as published, the edges by choice.
template <Frame frame, Division division, Root root, EdgeDegree degree>
using EdgesCell =
    Rung<PlaneForm::cross_multiplied, VertexForm::distributed, EdgeCell<EdgeChoices{frame, division, root, degree}>>;

// Each step makes one rewriting, in the article's order: the plane, the vertices, the edges. Ladder4, 5, 7 and 8 are
// cells of the edges' choices; so is the reduced form, of degree 4 where Ladder8 has 6.
using RootedWorldEdge = EdgeCell<EdgeChoices{Frame::world, Division::divided, Root::rooted, EdgeDegree::six}>;
using Ladder0 = Rung<PlaneForm::normalised, VertexForm::rooted, RootedWorldEdge>;
using Ladder1 = Rung<PlaneForm::squared, VertexForm::rooted, RootedWorldEdge>;
using Ladder2 = Rung<PlaneForm::divided, VertexForm::rooted, RootedWorldEdge>;
using Ladder3 = Rung<PlaneForm::cross_multiplied, VertexForm::rooted, RootedWorldEdge>;
using Ladder4 = EdgesCell<Frame::world, Division::divided, Root::rooted, EdgeDegree::six>;
using Ladder5 = EdgesCell<Frame::world, Division::divided, Root::squared, EdgeDegree::six>;
using Ladder6 = Rung<PlaneForm::cross_multiplied, VertexForm::distributed, ScaledEdge>;
using Ladder7 = EdgesCell<Frame::world, Division::multiplied, Root::squared, EdgeDegree::six>;
using Ladder8 = EdgesCell<Frame::centred, Division::multiplied, Root::squared, EdgeDegree::six>;
using Ladder9 = Rung<PlaneForm::cross_multiplied, VertexForm::distributed, DistributedEdge>;

// The cells off the article's path.
using EdgesWorldMultipliedRooted6 = EdgesCell<Frame::world, Division::multiplied, Root::rooted, EdgeDegree::six>;
using EdgesCentredDividedRooted6 = EdgesCell<Frame::centred, Division::divided, Root::rooted, EdgeDegree::six>;
using EdgesCentredDividedSquared6 = EdgesCell<Frame::centred, Division::divided, Root::squared, EdgeDegree::six>;
using EdgesCentredMultipliedRooted6 = EdgesCell<Frame::centred, Division::multiplied, Root::rooted, EdgeDegree::six>;
using EdgesWorldDividedRooted4 = EdgesCell<Frame::world, Division::divided, Root::rooted, EdgeDegree::four>;
using EdgesWorldDividedSquared4 = EdgesCell<Frame::world, Division::divided, Root::squared, EdgeDegree::four>;
using EdgesWorldMultipliedRooted4 = EdgesCell<Frame::world, Division::multiplied, Root::rooted, EdgeDegree::four>;
using EdgesWorldMultipliedSquared4 = EdgesCell<Frame::world, Division::multiplied, Root::squared, EdgeDegree::four>;
using EdgesCentredDividedRooted4 = EdgesCell<Frame::centred, Division::divided, Root::rooted, EdgeDegree::four>;
using EdgesCentredDividedSquared4 = EdgesCell<Frame::centred, Division::divided, Root::squared, EdgeDegree::four>;
using EdgesCentredMultipliedRooted4 = EdgesCell<Frame::centred, Division::multiplied, Root::rooted, EdgeDegree::four>;
// Those of the plane: Ladder2 and Ladder3 are the squared ones.
using PlaneDividedRooted = Rung<PlaneForm::divided_rooted, VertexForm::rooted, RootedWorldEdge>;
using PlaneMultipliedRooted = Rung<PlaneForm::multiplied_rooted, VertexForm::rooted, RootedWorldEdge>;

}  // namespace axiscert::rungs
