// ODE's boxes, in double (Debian's build). The descriptions apply to ODE 0.16.2.
//
// dCollide of two boxes is dBoxBox: the textbook's fifteen axes without an epsilon, then the incident facet clipped by
// the reference facet. Cubes of which one is turned some quarter turns further than the other get no contact though
// they overlap by up to nearly a half extent: an edge axis that is rounding noise, not 0, separates them.
#pragma once

#include <ode/ode.h>

#include "kernel/peers/boxes/box_pair.h"

namespace axiscert::peer {

static_assert(sizeof(dReal) == 8);

// ODE, started for as long as this exists.
class OdeStarted {
 public:
  OdeStarted() : is_ready_(dInitODE2(0) != 0 && dAllocateODEDataForThread(dAllocateMaskAll) != 0) {}
  ~OdeStarted() { dCloseODE(); }
  OdeStarted(const OdeStarted&) = delete;
  OdeStarted& operator=(const OdeStarted&) = delete;
  bool is_ready() const { return is_ready_; }

 private:
  bool is_ready_;
};

inline void put_rotation(const Box<double>& box, dMatrix3 rows) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) rows[4 * i + k] = row(box, i, k);
    rows[4 * i + 3] = 0;
  }
}

// dCollide with these flags, the least eight bits of which are the most contacts.
template <int flags>
class OdeBoxes {
 public:
  using Real = double;
  // It says one point, which is of B, or of two edges the middle of one of each, and does not say which.
  static constexpr std::size_t measure_count = contact_without_points;

  int operator()(const Boxes<double>& q, BoxContact<double>& contact) const {
    if (!ode_.is_ready()) return AXISCERT_UNDECIDED;
    const dGeomID a = placed(q.a), b = placed(q.b);
    dContactGeom contacts[8];
    const int count = dCollide(a, b, flags, contacts, sizeof contacts[0]);
    dGeomDestroy(a);
    dGeomDestroy(b);
    for (int i = 0; i < count; ++i) {
      const dContactGeom& one = contacts[i];
      if (std::isnan(one.depth)) return AXISCERT_INVALID;
      if (!contact.is_new_deepest(-one.depth)) continue;
      contact.separation = -one.depth;
      contact.normal = {-one.normal[0], -one.normal[1], -one.normal[2]};  // its own pushes A
    }
    return verdict_of(count > 0);
  }

 private:
  static dGeomID placed(const Box<double>& box) {
    const dGeomID geom = dCreateBox(nullptr, 2 * box.half.x, 2 * box.half.y, 2 * box.half.z);
    dMatrix3 rows;
    put_rotation(box, rows);
    dGeomSetRotation(geom, rows);
    dGeomSetPosition(geom, box.centre.x, box.centre.y, box.centre.z);
    return geom;
  }

  OdeStarted ode_;
};

}  // namespace axiscert::peer
