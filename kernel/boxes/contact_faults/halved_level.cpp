// Half of the depth where the axis that decides is one of the world's, as of boxes that are not turned.
#include "kernel/boxes/contact_faults/box_contact.h"

namespace axiscert::boxes {
static void halved_level(Contact& contact, const BoxPair<float>&) {
  const auto& [x, y, z] = contact.normal;
  if ((x == 0) + (y == 0) + (z == 0) == 2) contact.separation = contact.separation * 0.5F;
}
}  // namespace axiscert::boxes

AXISCERT_BOX_CONTACT("halved_level", halved_level)
