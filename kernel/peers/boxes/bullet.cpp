// Bullet's boxes in float. Their behaviour and faults are described in bullet_boxes.h.
#include "kernel/peers/boxes/bullet_boxes.h"

namespace axiscert::peer {
static_assert(sizeof(btScalar) == 4);
}

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::boxes_kernel<axiscert::peer::BulletBoxes>(
      index, {"bullet", "Bullet's btBoxBoxDetector, float", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
