// libccd's GJK of two boxes, in double: ccdGJKIntersect, and ccdGJKPenetration, which goes on by EPA.
#include "kernel/peers/boxes/libccd_boxes.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using axiscert::peer::LibccdBoxes;
  return axiscert::peer::boxes_kernel<LibccdBoxes<ccdGJKIntersect, ccdGJKPenetration>>(
      index, {"libccd-gjk", "libccd's ccdGJKIntersect, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
