// Bullet as games ask it, in float: convexSweepTest of a collision world that has one static btBvhTriangleMeshShape of
// this triangle, whose margin is 0 as it is made. The description applies to Bullet 3.24. Its answers are nearly those
// of btContinuousConvexCollision; it drops a hit whose normal is 0 and one whose time is 1.
#include <memory>

#include "kernel/peers/moving_sphere/bullet_cast.h"

namespace axiscert::peer {
namespace {

class BulletWorld {
 public:
  using Real = float;
  static constexpr std::size_t measure_count = sweep_measures;
  static constexpr bool may_decline = true;

  int operator()(const Sweep<float>& q, FirstContact<float>& first) const {
    if (!is_finite(end_of(q))) return AXISCERT_UNDECIDED;
    btDbvtBroadphase broadphase;
    btCollisionWorld world(dispatcher_.get(), &broadphase, configuration_.get());
    btTriangleMesh triangles;
    triangles.addTriangle(bullet_vector(q.a), bullet_vector(q.b), bullet_vector(q.c));
    btBvhTriangleMeshShape mesh(&triangles, true);
    btCollisionObject object;
    object.setCollisionShape(&mesh);
    world.addCollisionObject(&object);

    const btSphereShape sphere(q.r);
    const btTransform from = bullet_place(q.p), to = bullet_place(end_of(q));
    btCollisionWorld::ClosestConvexResultCallback found(from.getOrigin(), to.getOrigin());
    world.convexSweepTest(&sphere, from, to, found);
    world.removeCollisionObject(&object);
    first.time = found.m_closestHitFraction;
    first.normal = from_bullet(found.m_hitNormalWorld);
    first.point = from_bullet(found.m_hitPointWorld);
    return verdict_of_hit(found.hasHit(), found.m_closestHitFraction);
  }

 private:
  // They have pools of memory, and nothing of a query.
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_ = std::make_unique<btDefaultCollisionConfiguration>();
  std::unique_ptr<btCollisionDispatcher> dispatcher_ = std::make_unique<btCollisionDispatcher>(configuration_.get());
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::sweep_kernel<axiscert::peer::BulletWorld>(
      index, {"bullet-world", "Bullet's convexSweepTest against a mesh of one triangle, float",
              AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
