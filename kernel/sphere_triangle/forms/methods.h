// Methods other than the article's: the closest point of the triangle, the triangle inflated by the radius, and a
// reader's variant with seven axes.
#pragma once

#include "kernel/sphere_triangle/forms/contacts.h"
#include "kernel/sphere_triangle/formulae.h"

namespace axiscert::methods {
// The closest point of the triangle, found by a walk through its Voronoi regions, then one comparison of distances.
// Tests the vertex, edge and face regions in turn by signs of dot products; interpolation weights need divisions.
//
// Touching is contact. Where A = B the region of that edge is entered with weight 0/0: the squared distance is then
// NaN, no comparison holds, and the answer is contact. Over the reals it is right for every other triangle.
// Source: the method of C. Ericson, Real-Time Collision Detection (2005), section 5.1.5.
struct ClosestPoint {
  static constexpr bool is_ring = false;

  template <class T>
  constexpr static NearestPart<T> nearest(const portable::CentredProblem<T>& centred, const T& zero) {
    const auto& [A, B, C, rr] = centred;
    const auto AB = B - A, AC = C - A;
    const T one_a = zero - dot(AB, A), two_a = zero - dot(AC, A);
    if (!(one_a > zero) && !(two_a > zero)) return {A, 0};
    const T one_b = zero - dot(AB, B), two_b = zero - dot(AC, B);
    if (one_b >= zero && one_b >= two_b) return {B, 1};
    const T weight_c = one_a * two_b - one_b * two_a;
    if (zero >= weight_c && one_a >= zero && zero >= one_b) return {A + AB * (one_a / (one_a - one_b)), 3};
    const T one_c = zero - dot(AB, C), two_c = zero - dot(AC, C);
    if (two_c >= zero && two_c >= one_c) return {C, 2};
    const T weight_b = one_c * two_a - one_a * two_c;
    if (zero >= weight_b && two_a >= zero && zero >= two_c) return {A + AC * (two_a / (two_a - two_c)), 5};
    const T weight_a = one_b * two_c - one_c * two_b;
    const T past_b = two_b - one_b, past_c = one_c - two_c;
    if (zero >= weight_a && past_b >= zero && past_c >= zero) return {B + (C - B) * (past_b / (past_b + past_c)), 4};
    const T all = (weight_a + weight_b) + weight_c;
    return {(A + AB * (weight_b / all)) + AC * (weight_c / all), 6};
  }
  template <class T>
  static portable::Vec3<T> closest(const portable::CentredProblem<T>& centred, const T& zero) {
    return nearest(centred, zero).point;
  }

  template <class T>
  constexpr static bool separated(const portable::Problem<T>& q) {
    const auto centred = portable::centred(q);
    const auto Q = closest(centred, q.zero);
    return dot(Q, Q) > centred.rr;
  }

  static constexpr std::size_t measure_count = contact_measures;
  template <class Real>
  static void measure(const portable::Problem<Real>& q, Real* out) {
    closest_point_contact(q, nearest(portable::centred(q), q.zero), separated(q), out);
  }
};

// Tests whether the centre is in the triangle inflated by the radius: three spheres, three cylinders, one prism.

// Spheres at the vertices, cylinders around the edges' interiors, a prism over the triangle's interior; their outer
// surfaces belong to them, so that touching is contact. The formulae are a ring: every bound is multiplied by |AB|^2 or
// |V|^2. Degree 6.
//
// A repeated vertex has no cylinder and a zero-area triangle has no prism (their strict bounds fail), and the remaining
// spheres and cylinders cover the shape: over the reals the test is right for every triangle.
// Source: C. Ericson, "Optimizing a sphere-triangle intersection test" (2010), "grow the triangle by the sphere".
struct Minkowski {
  static constexpr bool is_ring = true;
  template <class T>
  constexpr static bool separated(const portable::Problem<T>& q) {
    const auto centred = portable::centred(q);
    const auto& [A, B, C, rr] = centred;
    const auto outside_sphere = [&](const auto& at) { return dot(at, at) > rr; };
    const auto outside_cylinder = [&](const auto& from, const auto& to) {
      const auto along = to - from;
      const T t = q.zero - dot(from, along), e = dot(along, along);
      const auto Q = from * e + along * t;  // the foot of the origin, times e
      return !(t > q.zero) || !(e > t) || dot(Q, Q) > portable::times_square(rr, e);
    };
    const auto V = cross(B - A, C - A);
    const auto outside_prism = [&] {
      const auto inside_of = [&](const auto& from, const auto& to) { return dot(cross(from, to), V) > q.zero; };
      const T d = dot(A, V);
      return !inside_of(A, B) || !inside_of(B, C) || !inside_of(C, A) || d * d > rr * dot(V, V);
    };
    return outside_sphere(A) && outside_sphere(B) && outside_sphere(C) && outside_cylinder(A, B) &&
           outside_cylinder(B, C) && outside_cylinder(C, A) && outside_prism();
  }

  static constexpr std::size_t measure_count = contact_measures;
  template <class Real>
  static void measure(const portable::Problem<Real>& q, Real* out) {
    minkowski_contact(q, separated(q), out);
  }
};

// A reader's variant of the test: the edge axes through the closest point of each *segment*, which makes the vertex
// axes superfluous. It has seven comparisons; those of the vertices are emitted as 0 > 0, which never holds.
//
// Source: the discussion below C. Ericson, "Optimizing a sphere-triangle intersection test" (2010), comment 4.

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
