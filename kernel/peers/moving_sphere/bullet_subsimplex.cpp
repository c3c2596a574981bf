// btSubsimplexConvexCast: a ray against the Minkowski difference, its simplex kept as it goes. It stops where the
// squared distance that is left is below 1e-4, in the square of the user's unit. Its header, btSubSimplexConvexCast.h,
// makes it a precondition that the two do not overlap at the start, and calls results undefined where they do.
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>

#include "kernel/peers/moving_sphere/bullet_cast.h"

namespace axiscert::peer {
namespace {

struct Subsimplex {
  Subsimplex(const btSphereShape& sphere, const btTriangleShape& triangle, btVoronoiSimplexSolver& simplex)
      : method(&sphere, &triangle, &simplex) {}
  btSubsimplexConvexCast method;
};

struct SubsimplexCast : BulletCast<Subsimplex> {
  static constexpr std::uint32_t start = AXISCERT_START_IS_IGNORED;
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::sweep_kernel<axiscert::peer::SubsimplexCast>(
      index,
      {"bullet-subsimplex", "Bullet's btSubsimplexConvexCast, float", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
