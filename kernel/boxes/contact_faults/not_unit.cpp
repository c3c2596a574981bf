// The normal has the length 1.5.
#include "kernel/boxes/contact_faults/box_contact.h"

namespace axiscert::boxes {
static void not_unit(Contact& contact, const BoxPair<float>&) { contact.normal = contact.normal * 1.5F; }
}  // namespace axiscert::boxes

AXISCERT_BOX_CONTACT("not_unit", not_unit)
