// The point of each box is said to be the other's.
#include <utility>

#include "kernel/boxes/contact_faults/box_contact.h"

namespace axiscert::boxes {
static void swapped(Contact& contact, const BoxPair<float>&) { std::swap(contact.point_a, contact.point_b); }
}  // namespace axiscert::boxes

AXISCERT_BOX_CONTACT("swapped", swapped)
