// Bullet's casts of one convex shape against another, in float: a btConvexCast of a sphere against a triangle without a
// margin. The description applies to Bullet 3.24.
//
// Bullet takes where the sphere ends, so p + d is rounded before it is asked. A motion of length 0 is never a contact,
// whatever overlaps at the start.
#pragma once

#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <btBulletCollisionCommon.h>

#include "kernel/peers/moving_sphere/sweep.h"

namespace axiscert::peer {

static_assert(sizeof(btScalar) == 4);

inline btVector3 bullet_vector(const Vec3<float>& v) { return {v.x, v.y, v.z}; }
inline Vec3<float> from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline btTransform bullet_place(const Vec3<float>& v) {
  return btTransform(btMatrix3x3::getIdentity(), bullet_vector(v));
}

// Cast::made(sphere, triangle, simplex) makes the btConvexCast. All objects are new for each query.
template <class Cast>
struct BulletCast {
  using Real = float;
  static constexpr std::size_t measure_count = sweep_measures;
  static constexpr bool may_decline = true;

  int operator()(const Sweep<float>& q, FirstContact<float>& first) const {
    if (!is_finite(end_of(q))) return AXISCERT_UNDECIDED;
    const btSphereShape sphere(q.r);
    btTriangleShape triangle(bullet_vector(q.a), bullet_vector(q.b), bullet_vector(q.c));
    triangle.setMargin(0);  // the triangle has no thickness; the sphere's margin is its radius
    btVoronoiSimplexSolver simplex;
    Cast cast(sphere, triangle, simplex);
    btConvexCast::CastResult found;
    found.m_fraction = 1;  // as btCollisionWorld sets it
    const btTransform still = btTransform::getIdentity();
    const bool is_hit = cast.method.calcTimeOfImpact(bullet_place(q.p), bullet_place(end_of(q)), still, still, found);
    first.time = found.m_fraction;
    first.normal = from_bullet(found.m_normal);
    first.point = from_bullet(found.m_hitPoint);
    return verdict_of_hit(is_hit, found.m_fraction);
  }
};

}  // namespace axiscert::peer
