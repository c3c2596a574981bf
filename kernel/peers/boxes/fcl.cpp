// FCL's collide of two boxes, which is boxBox2, in double. The description applies to FCL 0.7.0: its edge axes are
// raised by a fudge of 10 u times the greatest extent, a length that is added to a cosine.
#include "kernel/peers/boxes/fcl_placed.h"

namespace axiscert::peer {
namespace {

struct FclBoxes {
  using Real = double;
  // It says one point, and not of which body.
  static constexpr std::size_t measure_count = contact_without_points;

  int operator()(const Boxes<double>& q, BoxContact<double>& contact) const {
    const fcl::Box<double> a(fcl_vector(q.a.half) * 2), b(fcl_vector(q.b.half) * 2);
    const fcl::CollisionRequest<double> asked(8, true);
    fcl::CollisionResult<double> found;
    fcl::collide<double>(&a, placed(q.a), &b, placed(q.b), asked, found);
    for (std::size_t i = 0; i < found.numContacts(); ++i) {
      const fcl::Contact<double>& one = found.getContact(i);
      if (!contact.is_new_deepest(-one.penetration_depth)) continue;
      contact.separation = -one.penetration_depth;
      contact.normal = {one.normal.x(), one.normal.y(), one.normal.z()};
    }
    return verdict_of(found.isCollision());
  }

 private:
  static fcl::Transform3<double> placed(const Box<double>& box) {
    fcl::Transform3<double> to = fcl::Transform3<double>::Identity();
    to.linear() = fcl_rotation(box);
    to.translation() = fcl_vector(box.centre);
    return to;
  }
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::boxes_kernel<axiscert::peer::FclBoxes>(
      index, {"fcl", "FCL's collide of two boxes (boxBox2), double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
