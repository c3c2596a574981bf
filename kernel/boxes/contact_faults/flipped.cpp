// The normal goes from the second box to the first.
#include "kernel/boxes/contact_faults/box_contact.h"

namespace axiscert::boxes {
static void flipped(Contact& contact, const BoxPair<float>&) { contact.normal = contact.normal * -1.0F; }
}  // namespace axiscert::boxes

AXISCERT_BOX_CONTACT("flipped", flipped)
