// The sixteen comparisons of the published test, stated once, over any number type with + - * (float, double, a SIMD
// vector, exact binary numbers, MPFR). Straight-line ring arithmetic: no division, no root, no branch on a computed
// value.
//
// Source: C. Ericson, "Optimizing a sphere-triangle intersection test" (2010), last block of pseudocode. Operation
// order: kernel/base/geometry.h, which also says why there is no guard for AXISCERT_PER_TARGET.
#if defined(AXISCERT_PER_TARGET) || !defined(AXISCERT_KERNEL_FORMULAE_H)
#define AXISCERT_KERNEL_FORMULAE_H

#include "kernel/base/geometry.h"
#include "kernel/sphere_triangle/names.h"

AXISCERT_BEFORE_NAMESPACE();
namespace axiscert {
namespace AXISCERT_TARGET {

template <class T>
struct DotProducts {
  T aa, ab, ac, bb, bc, cc;
};
template <class T>
AXISCERT_INLINE DotProducts<T> dot_products(const CentredProblem<T>& q) {
  return {dot(q.a, q.a), dot(q.a, q.b), dot(q.a, q.c), dot(q.b, q.b), dot(q.b, q.c), dot(q.c, q.c)};
}

// The nine comparisons of the vertex axes, in their order.
template <class T, class Emit>
AXISCERT_INLINE void vertex_comparisons(const DotProducts<T>& dots, const T& rr, Emit&& emit) {
  using enum Comparison;
  const auto& [aa, ab, ac, bb, bc, cc] = dots;
  emit(vertex_a_radius, aa, rr);
  emit(vertex_a_side_b, ab, aa);
  emit(vertex_a_side_c, ac, aa);
  emit(vertex_b_radius, bb, rr);
  emit(vertex_b_side_a, ab, bb);
  emit(vertex_b_side_c, bc, bb);
  emit(vertex_c_radius, cc, rr);
  emit(vertex_c_side_a, ac, cc);
  emit(vertex_c_side_b, bc, cc);
}

// Emits all sixteen comparisons, in their order, as emit(which, lhs, rhs).
//
// plane.radius   beyond the plane of ABC                     degree 6; zero area: 0 > 0, never separates
// vertex.radius  vertex A is outside the sphere              degree 2
// vertex.side    B is beyond the plane at A, normal A - P    degree 2; A = B: equal sides
// edge.radius    the line AB is outside the sphere           degree 6; A = B: 0 > 0, never separates
// edge.side      C is beyond the plane along AB, normal Q    degree 6; Q: foot of P on line AB, scaled by |AB|^2;
//                C on line AB: 0 > 0
// Over the reals the strict test is right for every triangle with area; on zero-area triangles the zero sides above
// make it invent contacts, which `>=` in the nine side comparisons avoids.
template <class T, class Emit>
AXISCERT_INLINE void published_comparisons(const CentredProblem<T>& query, const T& zero, Emit&& emit) {
  using enum Comparison;
  const Vec3<T>&A = query.a, &B = query.b, &C = query.c;
  const T& rr = query.rr;
  const Vec3<T> AB = B - A, BC = C - B, CA = A - C;

  const Vec3<T> V = cross(AB, C - A);
  const T d = dot(A, V);
  const T e = dot(V, V);
  emit(plane_radius, d * d, rr * e);

  const DotProducts<T> dots = dot_products(query);
  const auto& [aa, ab, ac, bb, bc, cc] = dots;
  vertex_comparisons(dots, rr, emit);

  const T d1 = ab - aa, e1 = dot(AB, AB);
  const Vec3<T> Q1 = A * e1 - AB * d1;
  const Vec3<T> QC = C * e1 - Q1;
  emit(edge_ab_radius, dot(Q1, Q1), times_square(rr, e1));
  emit(edge_ab_side_c, dot(Q1, QC), zero);

  const T d2 = bc - bb, e2 = dot(BC, BC);
  const Vec3<T> Q2 = B * e2 - BC * d2;
  const Vec3<T> QA = A * e2 - Q2;
  emit(edge_bc_radius, dot(Q2, Q2), times_square(rr, e2));
  emit(edge_bc_side_a, dot(Q2, QA), zero);

  const T d3 = ac - cc, e3 = dot(CA, CA);
  const Vec3<T> Q3 = C * e3 - CA * d3;
  const Vec3<T> QB = B * e3 - Q3;
  emit(edge_ca_radius, dot(Q3, Q3), times_square(rr, e3));
  emit(edge_ca_side_b, dot(Q3, QB), zero);
}

struct PublishedFormulae {
  static constexpr bool is_ring = true;  // no division, no root
  template <class T, class Emit>
  AXISCERT_INLINE static void comparisons(const Problem<T>& query, Emit&& emit) {
    published_comparisons(centred(query), query.zero, emit);
  }
};

}  // namespace AXISCERT_TARGET
}  // namespace axiscert
AXISCERT_AFTER_NAMESPACE();
#endif
