// Bullet in float, as most games build it. Its behaviour and faults are described in bullet_detector.h.
#include "kernel/peers/bullet_detector.h"

namespace axiscert::peer {
static_assert(sizeof(btScalar) == 4);
}

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using axiscert::peer::BulletDetector;
  return axiscert::peer::kernel<BulletDetector>(
      index, {"bullet", "Bullet's SphereTriangleDetector::collide, float", BulletDetector::touching, AXISCERT_SOURCE});
}
