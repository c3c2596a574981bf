// btContinuousConvexCollision: conservative advancement over btGjkPairDetector, with EPA for the depth of a
// penetration.
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>

#include "kernel/peers/moving_sphere/bullet_cast.h"

namespace axiscert::peer {
namespace {

struct Continuous {
  Continuous(const btSphereShape& sphere, const btTriangleShape& triangle, btVoronoiSimplexSolver& simplex)
      : method(&sphere, &triangle, &simplex, &depth) {}
  btGjkEpaPenetrationDepthSolver depth;
  btContinuousConvexCollision method;
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::sweep_kernel<axiscert::peer::BulletCast<axiscert::peer::Continuous>>(
      index, {"bullet-continuous", "Bullet's btContinuousConvexCollision, float", AXISCERT_TOUCHING_IS_EITHER,
              AXISCERT_SOURCE});
}
