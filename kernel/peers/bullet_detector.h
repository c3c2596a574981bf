// Bullet's sphere against a triangle, in whichever number type Bullet was built: SphereTriangleDetector::collide. The
// description applies to Bullet 3.24; a float64 build exports the same symbols, so each number type is a plug-in of its
// own.
//
// It skips a triangle whose normal (a cross product, before division by its length) is shorter than SIMD_EPSILON,
// 1.19e-7 or 2.2e-16: every degenerate triangle, and every triangle of a small scene, has no contacts. Tracker: bullet3
// 935, 940, 1623.
#pragma once

#include <BulletCollision/CollisionDispatch/SphereTriangleDetector.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <btBulletCollisionCommon.h>

#include "kernel/peers/peer.h"

namespace axiscert::peer {

inline btVector3 bullet_vector(const Vec3<btScalar>& v) { return {v.x, v.y, v.z}; }

inline Vec3<btScalar> plain(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

struct BulletDetector {
  using Real = btScalar;
  static constexpr std::size_t measure_count = whole_answer;
  // Contact iff distance < radius, on every query.
  static constexpr axiscert_touching touching = AXISCERT_TOUCHING_IS_SEPARATED;

  int operator()(const Query<btScalar>& q, Contact<btScalar>& said) const {
    btSphereShape sphere(q.r);
    btTriangleShape triangle(bullet_vector(q.a), bullet_vector(q.b), bullet_vector(q.c));
    SphereTriangleDetector detector(&sphere, &triangle, 0);
    btVector3 point, normal;
    btScalar depth = 0, time_of_impact = 0;
    const bool contact = detector.collide(bullet_vector(q.p), point, normal, depth, time_of_impact, 0);
    if (std::isnan(depth)) return AXISCERT_INVALID;
    // Its depth is a distance, negative where the two overlap; the point is the triangle's.
    if (contact) said = {depth, plain(normal), plain(point)};
    return verdict_of(contact);
  }
};

}  // namespace axiscert::peer
