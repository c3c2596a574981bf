// FCL's continuousCollide of a mesh of one triangle and a sphere that is translated, in double. The description applies
// to FCL 0.7.0. It takes where the sphere ends, so p + d is rounded before it is asked. It gives a time, and neither
// normal nor point.
#pragma once

#include <fcl/fcl.h>

#include <memory>
#include <vector>

#include "kernel/peers/moving_sphere/sweep.h"

namespace axiscert::peer {

inline fcl::Vector3<double> fcl_vector(const Vec3<double>& v) { return {v.x, v.y, v.z}; }
inline fcl::Transform3<double> fcl_translation(const Vec3<double>& v) {
  fcl::Transform3<double> to = fcl::Transform3<double>::Identity();
  to.translation() = fcl_vector(v);
  return to;
}

// Volume: the bounding volume of the mesh.
template <class Volume, fcl::CCDSolverType solver>
struct FclMotion {
  using Real = double;
  static constexpr std::size_t measure_count = 1;
  static constexpr bool may_decline = true;

  int operator()(const Sweep<double>& q, FirstContact<double>& first) const {
    if (!is_finite(end_of(q))) return AXISCERT_UNDECIDED;
    fcl::BVHModel<Volume> mesh;
    mesh.beginModel();
    mesh.addTriangle(fcl_vector(q.a), fcl_vector(q.b), fcl_vector(q.c));
    mesh.endModel();
    const fcl::Sphere<double> sphere(q.r);
    fcl::ContinuousCollisionRequest<double> asked;
    asked.ccd_solver_type = solver;
    fcl::ContinuousCollisionResult<double> found;
    const fcl::Transform3<double> still = fcl::Transform3<double>::Identity();
    fcl::continuousCollide<double>(&mesh, still, still, &sphere, fcl_translation(q.p), fcl_translation(end_of(q)),
                                   asked, found);
    first.time = found.time_of_contact;
    return verdict_of_hit(found.is_collide, found.time_of_contact);
  }
};

}  // namespace axiscert::peer
