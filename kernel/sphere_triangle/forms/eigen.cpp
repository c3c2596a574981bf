#include "kernel/sphere_triangle/forms/pair_forms.h"

#include <Eigen/Geometry>

#include "kernel/sphere_triangle/forms/scalar_kernel.h"

namespace axiscert {
namespace {

template <class Real, class Emit>
void comparisons(const Query<Real>& q, Emit&& emit) {
  using enum Comparison;
  using Vector = Eigen::Matrix<Real, 3, 1>;
  const auto vector = [](const Vec3<Real>& v) { return Vector(v.x, v.y, v.z); };
  const Vector P = vector(q.p), A = vector(q.a) - P, B = vector(q.b) - P, C = vector(q.c) - P;
  const Real rr = q.r * q.r;

  const Vector AB = B - A, BC = C - B, CA = A - C;
  const Vector V = AB.cross(C - A);
  const Real d = A.dot(V);
  emit(plane_radius, d * d, rr * V.squaredNorm());

  const Real aa = A.squaredNorm(), bb = B.squaredNorm(), cc = C.squaredNorm();
  const Real ab = A.dot(B), ac = A.dot(C), bc = B.dot(C);
  emit(vertex_a_radius, aa, rr);
  emit(vertex_a_side_b, ab, aa);
  emit(vertex_a_side_c, ac, aa);
  emit(vertex_b_radius, bb, rr);
  emit(vertex_b_side_a, ab, bb);
  emit(vertex_b_side_c, bc, bb);
  emit(vertex_c_radius, cc, rr);
  emit(vertex_c_side_a, ac, cc);
  emit(vertex_c_side_b, bc, cc);

  const auto edge = [&](const Vector& from, const Vector& along, const Vector& opposite, Real t, Comparison radius,
                        Comparison side) {
    const Real e = along.squaredNorm();
    const Vector Q = from * e - along * t;
    emit(radius, Q.squaredNorm(), rr * e * e);
    emit(side, Q.dot(opposite * e - Q), Real(0));
  };
  edge(A, AB, C, ab - aa, edge_ab_radius, edge_ab_side_c);
  edge(B, BC, A, bc - bb, edge_bc_radius, edge_bc_side_a);
  edge(C, CA, B, ac - cc, edge_ca_radius, edge_ca_side_b);
}

template <class Real>
void verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  for (std::size_t i = 0; i < batch.size; ++i) {
    ComparisonBits bits = 0;
    comparisons(query_at(batch, i), [&](Comparison which, Real lhs, Real rhs) {
      bits |= bit_if<ComparisonBits>(lhs > rhs, index_of(which));
    });
    out[i] = verdict_of(axes_of(bits));
  }
}

template <class Real>
void explain(const QueryColumns<Real>& batch, Answers<Real>& out) {
  for (std::size_t i = 0; i < batch.size; ++i) {
    out.bits[i] = 0;
    comparisons(query_at(batch, i), [&](Comparison which, Real lhs, Real rhs) {
      const auto k = index_of(which);
      out.lhs[k][i] = lhs;
      out.rhs[k][i] = rhs;
      out.bits[i] |= bit_if<ComparisonBits>(lhs > rhs, k);
    });
  }
}

}  // namespace

template <class Real>
Implementation<Real> eigen_implementation() {
  return {verdicts<Real>, explain<Real>};
}
template Implementation<float> eigen_implementation<float>();
template Implementation<double> eigen_implementation<double>();

}  // namespace axiscert
