// Bullet's btBoxBoxDetector, which is ODE's dBoxBox2 with an epsilon of 1e-5 on the edge axes, in btScalar. The
// description applies to Bullet 3.24.
//
// A contact is a point that the clipping finds; parallel boxes without an extent are missed, as it finds none of their
// contacts, whose axes all say contact. The shapes' extents include their margin.
#pragma once

#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <btBulletCollisionCommon.h>

#include "kernel/peers/boxes/box_pair.h"

namespace axiscert::peer {

struct BulletBoxes {
  using Real = btScalar;
  static constexpr std::size_t measure_count = whole_contact;

  int operator()(const Boxes<btScalar>& q, BoxContact<btScalar>& contact) const {
    btBoxShape a(vector(q.a.half)), b(vector(q.b.half));
    btBoxBoxDetector detector(&a, &b);
    btDiscreteCollisionDetectorInterface::ClosestPointInput input;
    input.m_transformA = placed(q.a);
    input.m_transformB = placed(q.b);
    input.m_maximumDistanceSquared = BT_LARGE_FLOAT;
    Points points;
    detector.getClosestPoints(input, points, nullptr);
    contact = points.deepest;
    return points.is_nan ? AXISCERT_INVALID : verdict_of(points.count > 0);
  }

 private:
  struct Points : btDiscreteCollisionDetectorInterface::Result {
    int count = 0;
    bool is_nan = false;
    BoxContact<btScalar> deepest;
    void setShapeIdentifiersA(int, int) override {}
    void setShapeIdentifiersB(int, int) override {}
    // The normal is that of B's surface, and the point is B's; A's is beyond it by the depth, which is negative.
    void addContactPoint(const btVector3& normal, const btVector3& at_b, btScalar depth) override {
      ++count;
      is_nan = is_nan || std::isnan(depth);
      if (!deepest.is_new_deepest(depth)) return;
      const btVector3 at_a = at_b + normal * depth;
      deepest = {depth, plain(-normal), plain(at_a), plain(at_b)};
    }
  };

  static Vec3<btScalar> plain(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
  static btVector3 vector(const Vec3<btScalar>& v) { return {v.x, v.y, v.z}; }
  static btTransform placed(const Box<btScalar>& box) {
    btMatrix3x3 rows;
    rows.setValue(row(box, 0, 0), row(box, 0, 1), row(box, 0, 2), row(box, 1, 0), row(box, 1, 1), row(box, 1, 2),
                  row(box, 2, 0), row(box, 2, 1), row(box, 2, 2));
    return btTransform(rows, vector(box.centre));
  }
};

}  // namespace axiscert::peer
