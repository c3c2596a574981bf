// Bullet's general convex test in float: btGjkPairDetector over btVoronoiSimplexSolver, with EPA for the depth of a
// penetration. The description applies to Bullet 3.24. Its thresholds are lengths: in scenes of size 1e-5 and smaller
// every query is a contact, whatever the distance.
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <btBulletCollisionCommon.h>

#include "kernel/peers/peer.h"

namespace axiscert::peer {
namespace {

static_assert(sizeof(btScalar) == 4);

btVector3 vector(const Vec3<float>& v) { return {v.x, v.y, v.z}; }
Vec3<float> plain(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

struct BulletGjk {
  using Real = float;
  static constexpr std::size_t measure_count = whole_answer;

  // All objects are new for each query: the detector would begin at the separating axis of its last query, the solver
  // with its last simplex.
  int operator()(const Query<float>& q, Contact<float>& said) const {
    btSphereShape sphere(q.r);
    btTriangleShape triangle(vector(q.a), vector(q.b), vector(q.c));
    triangle.setMargin(0);  // the triangle has no thickness; the sphere's margin is its radius
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btGjkPairDetector detector(&sphere, &triangle, &simplex, &depth);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA.setIdentity();
    input.m_transformA.setOrigin(vector(q.p));
    input.m_transformB.setIdentity();
    btPointCollector nearest;
    detector.getClosestPoints(input, nearest, nullptr);
    // Bullet gives no result beyond the greatest distance asked for, and where it finds no valid direction.
    if (!nearest.m_hasResult) return AXISCERT_SEPARATED;
    // The triangle is its second body: normal and point are of that.
    if (!std::isnan(nearest.m_distance))
      said = {nearest.m_distance, plain(nearest.m_normalOnBInWorld), plain(nearest.m_pointInWorld)};
    return verdict_within(nearest.m_distance, 0.0F);
  }
};

}  // namespace
}  // namespace axiscert::peer

// The detector gives a signed distance; 0, which is touching, counts as contact.
const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::kernel<axiscert::peer::BulletGjk>(
      index,
      {"bullet-gjk", "Bullet's btGjkPairDetector with EPA, float", AXISCERT_TOUCHING_IS_CONTACT, AXISCERT_SOURCE});
}
