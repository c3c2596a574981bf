// The control: as they are.
#include "kernel/boxes/contact_faults/box_contact.h"

namespace axiscert::boxes {
static void none(Contact& contact, const BoxPair<float>&) { static_cast<void>(contact); }
}  // namespace axiscert::boxes

AXISCERT_BOX_CONTACT("none", none)
