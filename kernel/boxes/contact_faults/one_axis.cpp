// The depth and the normal of A's first axis alone.
#include "kernel/boxes/contact_faults/box_contact.h"

namespace axiscert::boxes {
static void one_axis(Contact& contact, const BoxPair<float>& q) {
  const Vec3<float> between = q.b.centre - q.a.centre;
  const Vec3<float>& axis = q.a.axis[0];
  contact.normal = facing(axis, between);
  contact.separation = magnitude(dot(axis, between)) - half_extent(q.a, axis) - half_extent(q.b, axis);
}
}  // namespace axiscert::boxes

AXISCERT_BOX_CONTACT("one_axis", one_axis)
