// btSubsimplexConvexCast: a ray against the Minkowski difference, its simplex kept as it goes. It stops where the
// squared distance that is left is below 1e-4, in the square of the user's unit.
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>

#include "kernel/peers/moving_sphere/bullet_cast.h"

namespace axiscert::peer {
namespace {

struct Subsimplex {
  Subsimplex(const btSphereShape& sphere, const btTriangleShape& triangle, btVoronoiSimplexSolver& simplex)
      : method(&sphere, &triangle, &simplex) {}
  btSubsimplexConvexCast method;
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::sweep_kernel<axiscert::peer::BulletCast<axiscert::peer::Subsimplex>>(
      index,
      {"bullet-subsimplex", "Bullet's btSubsimplexConvexCast, float", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
