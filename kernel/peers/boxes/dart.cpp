// DART's own detector of two boxes, which is an old dBoxBox of ODE, in double. The description applies to DART 6.12.
#include <dart/collision/CollisionObject.hpp>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/SimpleFrame.hpp>

#include <memory>

#include "kernel/peers/boxes/box_pair.h"

namespace axiscert::peer {
namespace {

class DartBoxes {
 public:
  using Real = double;
  // It says one point, and not of which body.
  static constexpr std::size_t measure_count = contact_without_points;

  int operator()(const Boxes<double>& q, BoxContact<double>& contact) {
    // Its shapes have volume: without one an assertion of Debian's build fails.
    if (!has_volume(q.a) || !has_volume(q.b)) return AXISCERT_UNDECIDED;
    const auto a = placed(q.a), b = placed(q.b);
    const auto detector = dart::collision::DARTCollisionDetector::create();
    const auto of_a = detector->createCollisionGroup(a.get()), of_b = detector->createCollisionGroup(b.get());
    dart::collision::CollisionResult found;
    of_a->collide(of_b.get(), dart::collision::CollisionOption(true, 100), &found);
    for (const dart::collision::Contact& one : found.getContacts()) {
      if (std::isnan(one.penetrationDepth)) return AXISCERT_INVALID;
      if (!contact.is_new_deepest(-one.penetrationDepth)) continue;
      // Its normal goes from its second object to its first, whichever these are.
      const bool is_b_second = one.collisionObject2->getShapeFrame() == b.get();
      const double sign = is_b_second ? -1 : 1;
      contact.separation = -one.penetrationDepth;
      contact.normal = {sign * one.normal.x(), sign * one.normal.y(), sign * one.normal.z()};
    }
    return verdict_of(found.isCollision());
  }

 private:
  using Frame = dart::dynamics::SimpleFrame;

  static bool has_volume(const Box<double>& box) { return box.half.x > 0 && box.half.y > 0 && box.half.z > 0; }

  static std::shared_ptr<Frame> placed(const Box<double>& box) {
    const Eigen::Vector3d size(2 * box.half.x, 2 * box.half.y, 2 * box.half.z);
    Eigen::Isometry3d to = Eigen::Isometry3d::Identity();
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        to.linear()(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = row(box, i, k);
    }
    to.translation() = Eigen::Vector3d(box.centre.x, box.centre.y, box.centre.z);
    auto frame = std::make_shared<Frame>(dart::dynamics::Frame::World());
    frame->setShape(std::make_shared<dart::dynamics::BoxShape>(size));
    frame->setTransform(to);
    return frame;
  }
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::boxes_kernel<axiscert::peer::DartBoxes>(
      index, {"dart", "DART's own detector of two boxes, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
