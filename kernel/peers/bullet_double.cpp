// Bullet in double (BT_USE_DOUBLE_PRECISION). Its behaviour and faults are described in bullet_detector.h.
#include "kernel/peers/bullet_detector.h"

namespace axiscert::peer {
static_assert(sizeof(btScalar) == 8);
}

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using axiscert::peer::BulletDetector;
  return axiscert::peer::kernel<BulletDetector>(
      index,
      {"bullet-double", "Bullet's SphereTriangleDetector::collide, double", BulletDetector::touching, AXISCERT_SOURCE});
}
