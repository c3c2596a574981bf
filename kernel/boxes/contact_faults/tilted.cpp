// The normal is turned by a thousandth.
#include "kernel/boxes/contact_faults/box_contact.h"

namespace axiscert::boxes {
static void tilted(Contact& contact, const BoxPair<float>&) {
  const Vec3<float> across = cross(contact.normal, Vec3<float>{contact.normal.y, contact.normal.z, -contact.normal.x});
  contact.normal = unit(contact.normal + unit(across) * 0.001F);
}
}  // namespace axiscert::boxes

AXISCERT_BOX_CONTACT("tilted", tilted)
