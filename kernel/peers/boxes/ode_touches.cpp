// ODE's dBoxTouchesBox: the textbook's fifteen axes without an epsilon, and no clipping, in double.
#include "kernel/peers/boxes/ode_boxes.h"

namespace axiscert::peer {
namespace {

struct OdeTouches {
  using Real = double;

  int operator()(const Boxes<double>& q) const {
    dMatrix3 of_a, of_b;
    put_rotation(q.a, of_a);
    put_rotation(q.b, of_b);
    const dVector3 at_a = {q.a.centre.x, q.a.centre.y, q.a.centre.z}, at_b = {q.b.centre.x, q.b.centre.y, q.b.centre.z},
                   sides_a = {2 * q.a.half.x, 2 * q.a.half.y, 2 * q.a.half.z},
                   sides_b = {2 * q.b.half.x, 2 * q.b.half.y, 2 * q.b.half.z};
    return verdict_of(dBoxTouchesBox(at_a, of_a, sides_a, at_b, of_b, sides_b) != 0);
  }
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::boxes_kernel<axiscert::peer::OdeTouches>(
      index, {"ode-touches", "ODE's dBoxTouchesBox, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
