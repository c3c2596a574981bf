// Normals go to the first axis' positive side, whichever side the second box is on: what mirrored and exchanged boxes
// do not have.
#include "kernel/boxes/contact_faults/box_contact.h"

namespace axiscert::boxes {
static void one_sided(Contact& contact, const BoxPair<float>&) {
  if (contact.normal.x < 0) contact.normal = contact.normal * -1.0F;
}
}  // namespace axiscert::boxes

AXISCERT_BOX_CONTACT("one_sided", one_sided)
