// ODE's dCollide of two boxes, all contacts asked for; its faults are in ode_boxes.h.
#include "kernel/peers/boxes/ode_boxes.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::boxes_kernel<axiscert::peer::OdeBoxes<8>>(
      index, {"ode", "ODE's dCollide of two boxes, up to eight contacts, double", AXISCERT_TOUCHING_IS_EITHER,
              AXISCERT_SOURCE});
}
