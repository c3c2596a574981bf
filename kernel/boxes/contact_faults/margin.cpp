// A skin of 0.01 units of length on the boxes' numbers, and on no verdict.
#include "kernel/boxes/contact_faults/box_contact.h"

namespace axiscert::boxes {
static void margin(Contact& contact, const BoxPair<float>&) { contact.separation = contact.separation - 0.01F; }
}  // namespace axiscert::boxes

AXISCERT_BOX_CONTACT("margin", margin)
