// FCL's sphere against a triangle, over float or double: detail::sphereTriangleIntersect, which both of its
// narrow-phase solvers call for spheres. The description applies to FCL 0.7.0.
//
// A triangle without a normal has distance 0 from every plane and contains every point: each degenerate triangle
// "hits", at any distance (fcl 29 is of this kind). The machine epsilon of the number type is added to the radius as a
// length: 2.2e-16 metres mean nothing in a large scene and everything in a small one. Where a NaN occurs inside, for
// instance after an overflow, the answer is separated. Beside an edge the contact is that of the last edge within the
// radius, in the order AB, BC, CA.
#pragma once

#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_triangle.h>

#include "kernel/peers/peer.h"

namespace axiscert::peer {

template <class Number>
fcl::Vector3<Number> fcl_vector(const Vec3<Number>& v) {
  return {v.x, v.y, v.z};
}

template <class Number>
Vec3<Number> plain(const fcl::Vector3<Number>& v) {
  return {v.x(), v.y(), v.z()};
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
  static constexpr std::size_t measure_count = whole_answer;
  // Contact iff distance < radius + epsilon in that number type: at radius 1 touching is contact, at radius 4 it is
  // not.
  static constexpr axiscert_touching touching = AXISCERT_TOUCHING_IS_EITHER;

  // The normal goes from the sphere to the triangle, and the point is the triangle's. What it calls a depth is minus
  // one: so it is a separation as it stands, and collide() hands it on as a depth.
  int operator()(const Query<Number>& q, Contact<Number>& said) const {
    fcl::Vector3<Number> point, normal;
    Number depth;
    const bool contact =
        fcl::detail::sphereTriangleIntersect<Number>(fcl::Sphere<Number>(q.r), fcl_translation(q.p), fcl_vector(q.a),
                                                     fcl_vector(q.b), fcl_vector(q.c), &point, &depth, &normal);
    if (contact) said = {depth, plain<Number>(-normal), plain<Number>(point)};
    return verdict_of(contact);
  }
};

}  // namespace axiscert::peer
