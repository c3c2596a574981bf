// The closest point of the triangle, found by a walk through its Voronoi regions, then one comparison of distances.
#pragma once

#include "kernel/sphere_triangle/formulae.h"

namespace axiscert::methods {

// Predicates the vertex, edge and face regions in turn by signs of dot products; interpolation weights need divisions.
//
// Touching is contact. Where A = B the region of that edge is entered with weight 0/0: the squared distance is then
// NaN, no comparison holds, and the answer is contact. Over the reals it is right for every other triangle.
// Source: the method of C. Ericson, Real-Time Collision Detection (2005), section 5.1.5.
struct ClosestPoint {
  static constexpr bool is_ring = false;

  template <class T>
  static portable::Vec3<T> closest(const portable::CentredProblem<T>& centred, const T& zero) {
    const auto& [A, B, C, rr] = centred;
    const auto AB = B - A, AC = C - A;
    const T one_a = zero - dot(AB, A), two_a = zero - dot(AC, A);
    if (!(one_a > zero) && !(two_a > zero)) return A;
    const T one_b = zero - dot(AB, B), two_b = zero - dot(AC, B);
    if (one_b >= zero && one_b >= two_b) return B;
    const T weight_c = one_a * two_b - one_b * two_a;
    if (zero >= weight_c && one_a >= zero && zero >= one_b) return A + AB * (one_a / (one_a - one_b));
    const T one_c = zero - dot(AB, C), two_c = zero - dot(AC, C);
    if (two_c >= zero && two_c >= one_c) return C;
    const T weight_b = one_c * two_a - one_a * two_c;
    if (zero >= weight_b && two_a >= zero && zero >= two_c) return A + AC * (two_a / (two_a - two_c));
    const T weight_a = one_b * two_c - one_c * two_b;
    const T past_b = two_b - one_b, past_c = one_c - two_c;
    if (zero >= weight_a && past_b >= zero && past_c >= zero) return B + (C - B) * (past_b / (past_b + past_c));
    const T all = (weight_a + weight_b) + weight_c;
    return (A + AB * (weight_b / all)) + AC * (weight_c / all);
  }

  template <class T>
  static bool separated(const portable::Problem<T>& q) {
    const auto centred = portable::centred(q);
    const auto Q = closest(centred, q.zero);
    return dot(Q, Q) > centred.rr;
  }
};

}  // namespace axiscert::methods
