// Predicates whether the centre is in the triangle inflated by the radius: three spheres, three cylinders, one prism.
#pragma once

#include "kernel/sphere_triangle/formulae.h"

namespace axiscert::methods {

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
  static bool separated(const portable::Problem<T>& q) {
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
};

}  // namespace axiscert::methods
