// A reader's variant of the test: the edge axes through the closest point of each *segment*, which makes the vertex
// axes superfluous. It has seven comparisons; those of the vertices are emitted as 0 > 0, which never holds.
//
// Source: the discussion below C. Ericson, "Optimizing a sphere-triangle intersection test" (2010), comment 4.
#pragma once

#include "kernel/sphere_triangle/formulae.h"

namespace axiscert::methods {

// The point of segment AB closest to the origin. A = B gives A, without a division by zero.
template <class T>
portable::Vec3<T> closest_on_segment(const portable::Vec3<T>& A, const portable::Vec3<T>& B, const T& zero) {
  const auto AB = B - A;
  const T d = zero - dot(A, AB), e = dot(AB, AB);
  if (!(d > zero)) return A;
  if (!(e > d)) return B;
  return A + AB * (d / e);
}

// plane.radius   as published                                zero area: 0 > 0
// edge.radius    the segment AB is outside the sphere
// edge.side      C is beyond the plane at Q, normal Q - P    Q = C, or C on the plane: equal sides
// Over the reals the test is right for every triangle with area: where Q is a vertex A, the choice of Q implies that B
// is beyond the plane there, and the comparison checks C. On zero-area triangles the strict sides invent contacts, as
// the published ones do.
struct Segments {
  static constexpr bool is_ring = false;
  template <class T, class Emit>
  static void comparisons(const portable::Problem<T>& q, Emit&& emit) {
    using enum Comparison;
    const auto centred = portable::centred(q);
    const auto& [A, B, C, rr] = centred;
    const auto V = cross(B - A, C - A);
    const T d = dot(A, V);
    emit(plane_radius, d * d, rr * dot(V, V));
    for (int which = static_cast<int>(vertex_a_radius); which < static_cast<int>(edge_ab_radius); ++which) {
      emit(static_cast<Comparison>(which), q.zero, q.zero);
    }
    const auto edge = [&](const auto& from, const auto& to, const auto& opposite, Comparison radius, Comparison side) {
      const auto Q = closest_on_segment(from, to, q.zero);
      emit(radius, dot(Q, Q), rr);
      emit(side, dot(Q, opposite - Q), q.zero);
    };
    edge(A, B, C, edge_ab_radius, edge_ab_side_c);
    edge(B, C, A, edge_bc_radius, edge_bc_side_a);
    edge(C, A, B, edge_ca_radius, edge_ca_side_b);
  }
};

}  // namespace axiscert::methods
