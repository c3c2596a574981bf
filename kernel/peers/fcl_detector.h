// FCL's sphere against a triangle, over float or double: detail::sphereTriangleIntersect, which both of its
// narrow-phase solvers call for spheres. The description applies to FCL 0.7.0.
//
// A triangle without a normal has distance 0 from every plane and contains every point: each degenerate triangle
// "hits", at any distance (fcl 29 is of this kind). The machine epsilon of the number type is added to the radius as a
// length: 2.2e-16 metres mean nothing in a large scene and everything in a small one. Where a NaN occurs inside, for
// instance after an overflow, the answer is separated.
#pragma once

#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_triangle.h>

#include "kernel/peers/peer.h"

namespace axiscert::peer {

template <class Number>
fcl::Vector3<Number> fcl_vector(const Vec3<Number>& v) {
  return {v.x, v.y, v.z};
}

template <class Number>
fcl::Transform3<Number> fcl_translation(const Vec3<Number>& v) {
  fcl::Transform3<Number> to = fcl::Transform3<Number>::Identity();
  to.translation() = fcl_vector(v);
  return to;
}

template <class Number>
struct FclDetector {
  using Real = Number;
  // Contact iff distance < radius + epsilon in that number type: at radius 1 touching is contact, at radius 4 it is
  // not.
  static constexpr axiscert_touching touching = AXISCERT_TOUCHING_IS_EITHER;

  int operator()(const Query<Number>& q) const {
    return verdict_of(fcl::detail::sphereTriangleIntersect<Number>(fcl::Sphere<Number>(q.r), fcl_translation(q.p),
                                                                   fcl_vector(q.a), fcl_vector(q.b), fcl_vector(q.c),
                                                                   nullptr, nullptr, nullptr));
  }
};

}  // namespace axiscert::peer
