// libccd's MPR of two boxes, in double: ccdMPRIntersect, and ccdMPRPenetration. It stops where a step gains less than
// mpr_tolerance, 1e-4 as a length, and its loops ignore max_iterations (../libccd_mpr.cpp).
#include "kernel/peers/boxes/libccd_boxes.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using axiscert::peer::LibccdBoxes;
  return axiscert::peer::boxes_kernel<LibccdBoxes<ccdMPRIntersect, ccdMPRPenetration>>(
      index, {"libccd-mpr", "libccd's ccdMPRIntersect, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
