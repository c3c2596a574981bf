// A rung beyond the article: the edge axes at degree 4 in place of 6, with the signs of the published pair on every
// input.
//
// With N = A x B = A x AB, Q = A e - AB d and e = |AB|^2:  Q.Q = e |N|^2  and  Q.QC = -e (N.V).  Where e > 0, both
// factors e drop out of the comparisons; where e = 0, AB and N vanish and all four sides are zero, in the published
// pair too. Also d = A.V = det(A, B, C) = C.(A x B)  and  V = A x B + B x C + C x A.
#if defined(AXISCERT_PER_TARGET) || !defined(AXISCERT_KERNEL_RUNGS_REDUCED_H)
#define AXISCERT_KERNEL_RUNGS_REDUCED_H

#include "kernel/sphere_triangle/formulae.h"

AXISCERT_BEFORE_NAMESPACE();
namespace axiscert {
namespace AXISCERT_TARGET {

// How the normal N of an edge is computed: A x B from its ends, or A x AB along it. The products of A x B are as large
// as |A| |B|: where the triangle is small beside the sphere, they cancel, and |N| loses what A x AB keeps. Where the
// sphere is small, A x B is better, as B - A adds a rounding. docs/precision.md has the figures.
enum class EdgeNormal { by_ends, along };
// How the plane's normal V and offset d are computed. `shared` takes both from the edges' normals by their ends.
enum class PlaneTerms { published, determinant, shared };

// Emits all sixteen comparisons, in their order.
//
// plane.radius   as published                                degree 6
// vertex.*       as published                                degree 2
// edge.radius    |N|^2 > rr e                                degree 4; A = B: 0 > 0
// edge.side      0 > N.V: C beyond the plane along AB        degree 4; C on line AB: 0 > 0
template <EdgeNormal edge_normal, PlaneTerms plane>
struct ReducedForm {
  static constexpr bool is_ring = true;
  template <class T, class Emit>
  AXISCERT_INLINE static void comparisons(const Problem<T>& query, Emit&& emit) {
    using enum Comparison;
    const CentredProblem<T> centred = AXISCERT_TARGET::centred(query);
    const auto& [A, B, C, rr] = centred;
    const Vec3<T> AB = B - A, BC = C - B, CA = A - C;
    const auto normal = [](const Vec3<T>& from, const Vec3<T>& to, const Vec3<T>& along) {
      if constexpr (edge_normal == EdgeNormal::along) return cross(from, along);
      else return cross(from, to);
    };
    const Vec3<T> N1 = normal(A, B, AB), N2 = normal(B, C, BC), N3 = normal(C, A, CA);
    const Vec3<T> V = plane == PlaneTerms::shared ? (N1 + N2) + N3 : cross(AB, C - A);
    const T d = plane == PlaneTerms::published ? dot(A, V)
                : plane == PlaneTerms::shared  ? dot(C, N1)
                                               : dot(C, cross(A, B));
    emit(plane_radius, d * d, rr * dot(V, V));

    vertex_comparisons(dot_products(centred), centred.rr, emit);

    emit(edge_ab_radius, dot(N1, N1), rr * dot(AB, AB));
    emit(edge_ab_side_c, query.zero, dot(N1, V));
    emit(edge_bc_radius, dot(N2, N2), rr * dot(BC, BC));
    emit(edge_bc_side_a, query.zero, dot(N2, V));
    emit(edge_ca_radius, dot(N3, N3), rr * dot(CA, CA));
    emit(edge_ca_side_b, query.zero, dot(N3, V));
  }
};

using ReducedFormulae = ReducedForm<EdgeNormal::by_ends, PlaneTerms::published>;
using ReducedAlong = ReducedForm<EdgeNormal::along, PlaneTerms::published>;
using ReducedDeterminant = ReducedForm<EdgeNormal::by_ends, PlaneTerms::determinant>;
using ReducedShared = ReducedForm<EdgeNormal::by_ends, PlaneTerms::shared>;

}  // namespace AXISCERT_TARGET
}  // namespace axiscert
AXISCERT_AFTER_NAMESPACE();
#endif
