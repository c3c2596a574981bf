// Half of the depth, as that of a surface in the middle between both.
#include "kernel/boxes/contact_faults/box_contact.h"

namespace axiscert::boxes {
static void halved(Contact& contact, const BoxPair<float>&) { contact.separation = contact.separation * 0.5F; }
}  // namespace axiscert::boxes

AXISCERT_BOX_CONTACT("halved", halved)
