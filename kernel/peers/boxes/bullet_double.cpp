// Bullet's boxes in double. Their behaviour and faults are described in bullet_boxes.h.
#include "kernel/peers/boxes/bullet_boxes.h"

namespace axiscert::peer {
static_assert(sizeof(btScalar) == 8);
}

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::boxes_kernel<axiscert::peer::BulletBoxes>(
      index, {"bullet-double", "Bullet's btBoxBoxDetector, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
