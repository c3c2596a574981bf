// btGjkConvexCast::calcTimeOfImpact: conservative advancement over btGjkPairDetector, without a solver for the depth.
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>

#include "kernel/peers/moving_sphere/bullet_cast.h"

namespace axiscert::peer {
namespace {

struct GjkCast {
  GjkCast(const btSphereShape& sphere, const btTriangleShape& triangle, btVoronoiSimplexSolver& simplex)
      : method(&sphere, &triangle, &simplex) {}
  btGjkConvexCast method;
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::sweep_kernel<axiscert::peer::BulletCast<axiscert::peer::GjkCast>>(
      index, {"bullet-gjk-cast", "Bullet's btGjkConvexCast, float", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
