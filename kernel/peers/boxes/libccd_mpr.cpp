// libccd's MPR of two boxes, in double: ccdMPRIntersect. It stops where a step gains less than mpr_tolerance, 1e-4 as a
// length, and its loops ignore max_iterations (../libccd_mpr.cpp).
#include "kernel/peers/boxes/libccd_boxes.h"

namespace axiscert::peer {
namespace {

struct LibccdBoxesMpr {
  using Real = double;

  int operator()(const Boxes<double>& q) const {
    const ccd_t ccd = two_boxes();
    return verdict_of(ccdMPRIntersect(&q.a, &q.b, &ccd) != 0);
  }
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::boxes_kernel<axiscert::peer::LibccdBoxesMpr>(
      index, {"libccd-mpr", "libccd's ccdMPRIntersect, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
