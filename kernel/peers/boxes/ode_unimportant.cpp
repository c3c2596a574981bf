// ODE's dCollide of two boxes with CONTACTS_UNIMPORTANT, which is documented to skip "contact refining" alone. dBoxBox
// then stops at the first axis that does not separate, and often finds no point by its normal: contacts are missed.
#include "kernel/peers/boxes/ode_boxes.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  constexpr int flags = 8 | static_cast<int>(CONTACTS_UNIMPORTANT);
  return axiscert::peer::boxes_kernel<axiscert::peer::OdeBoxes<flags>>(
      index, {"ode-unimportant", "ODE's dCollide of two boxes, CONTACTS_UNIMPORTANT, double",
              AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
