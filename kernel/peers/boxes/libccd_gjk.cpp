// libccd's GJK of two boxes, in double: ccdGJKIntersect.
#include "kernel/peers/boxes/libccd_boxes.h"

namespace axiscert::peer {
namespace {

struct LibccdBoxesGjk {
  using Real = double;

  int operator()(const Boxes<double>& q) const {
    const ccd_t ccd = two_boxes();
    return verdict_of(ccdGJKIntersect(&q.a, &q.b, &ccd) != 0);
  }
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::boxes_kernel<axiscert::peer::LibccdBoxesGjk>(
      index, {"libccd-gjk", "libccd's ccdGJKIntersect, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
