// The sixteen comparisons, stated once, over any number type with + - * (float, double, a SIMD vector, CGAL::Mpzf,
// MPFR). Straight-line ring arithmetic: no division, no root, no branch on a computed value.
//
// Source: C. Ericson, "Optimizing a sphere-triangle intersection test" (2010), last block of pseudocode.
// Operation order, part of the contract of every kernel that claims these formulae:
//   dot = (x x' + y y') + z z',   cross.x = y z' - z y' (cyclic),   rr e e = (rr e) e.
//
// Included once by ordinary code, and again by simd.cpp, which defines AXISCERT_PER_TARGET, for each of Highway's
// instruction sets: the functions must carry that set's target attribute to be inlined. Hence no guard in that case,
// and a namespace by target.
#if defined(AXISCERT_PER_TARGET) || !defined(AXISCERT_KERNEL_FORMULAE_H)
#define AXISCERT_KERNEL_FORMULAE_H

#include "kernel/names.h"

#ifdef AXISCERT_PER_TARGET
#define AXISCERT_TARGET HWY_NAMESPACE
HWY_BEFORE_NAMESPACE();
#else
#define AXISCERT_TARGET portable
#endif
#undef AXISCERT_INLINE
#define AXISCERT_INLINE [[gnu::always_inline]] inline

namespace axiscert {
namespace AXISCERT_TARGET {

template <class T>
struct Vec3 {
  T x, y, z;
  AXISCERT_INLINE friend Vec3 operator+(const Vec3& u, const Vec3& v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }
  AXISCERT_INLINE friend Vec3 operator-(const Vec3& u, const Vec3& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
  AXISCERT_INLINE friend Vec3 operator*(const Vec3& u, const T& s) { return {u.x * s, u.y * s, u.z * s}; }
};

template <class T>
AXISCERT_INLINE T dot(const Vec3<T>& u, const Vec3<T>& v) {
  return (u.x * v.x + u.y * v.y) + u.z * v.z;
}

template <class T>
AXISCERT_INLINE Vec3<T> cross(const Vec3<T>& u, const Vec3<T>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

// The problem with the sphere's centre at the origin; rr is the squared radius.
template <class T>
struct Centred {
  Vec3<T> a, b, c;
  T rr;
};

template <class T>
AXISCERT_INLINE Centred<T> centred(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const Vec3<T>& p, const T& r) {
  return {a - p, b - p, c - p, r * r};
}

// Emits all sixteen comparisons, in their order, as emit(which, lhs, rhs).
//
// plane.radius   beyond the plane of ABC                     degree 6; zero area: 0 > 0, never separates
// vertex.radius  vertex A is outside the sphere              degree 2
// vertex.side    B is beyond the plane at A, normal A - P    degree 2; A = B: equal sides
// edge.radius    the line AB is outside the sphere           degree 6; A = B: 0 > 0, never separates
// edge.side      C is beyond the plane along AB, normal Q    degree 6; Q: foot of P on line AB, scaled by |AB|^2;
//                C on line AB: 0 > 0
// The strict test is right over the reals for every triangle with area; on zero-area triangles the zero sides above
// make it invent contacts, and `>=` in the nine side comparisons mends that.
template <class T, class Emit>
AXISCERT_INLINE void published_comparisons(const Centred<T>& query, const T& zero, Emit&& emit) {
  using enum Comparison;
  const Vec3<T>&A = query.a, &B = query.b, &C = query.c;
  const T& rr = query.rr;
  const Vec3<T> AB = B - A, BC = C - B, CA = A - C;

  const Vec3<T> V = cross(AB, C - A);
  const T d = dot(A, V);
  const T e = dot(V, V);
  emit(plane_radius, d * d, rr * e);

  const T aa = dot(A, A), ab = dot(A, B), ac = dot(A, C);
  const T bb = dot(B, B), bc = dot(B, C), cc = dot(C, C);
  emit(vertex_a_radius, aa, rr);
  emit(vertex_a_side_b, ab, aa);
  emit(vertex_a_side_c, ac, aa);
  emit(vertex_b_radius, bb, rr);
  emit(vertex_b_side_a, ab, bb);
  emit(vertex_b_side_c, bc, bb);
  emit(vertex_c_radius, cc, rr);
  emit(vertex_c_side_a, ac, cc);
  emit(vertex_c_side_b, bc, cc);

  const T d1 = ab - aa, e1 = dot(AB, AB);
  const Vec3<T> Q1 = A * e1 - AB * d1;
  const Vec3<T> QC = C * e1 - Q1;
  emit(edge_ab_radius, dot(Q1, Q1), (rr * e1) * e1);
  emit(edge_ab_side_c, dot(Q1, QC), zero);

  const T d2 = bc - bb, e2 = dot(BC, BC);
  const Vec3<T> Q2 = B * e2 - BC * d2;
  const Vec3<T> QA = A * e2 - Q2;
  emit(edge_bc_radius, dot(Q2, Q2), (rr * e2) * e2);
  emit(edge_bc_side_a, dot(Q2, QA), zero);

  const T d3 = ac - cc, e3 = dot(CA, CA);
  const Vec3<T> Q3 = C * e3 - CA * d3;
  const Vec3<T> QB = B * e3 - Q3;
  emit(edge_ca_radius, dot(Q3, Q3), (rr * e3) * e3);
  emit(edge_ca_side_b, dot(Q3, QB), zero);
}

}  // namespace AXISCERT_TARGET
}  // namespace axiscert

#ifdef AXISCERT_PER_TARGET
HWY_AFTER_NAMESPACE();
#endif
#undef AXISCERT_TARGET
#endif
