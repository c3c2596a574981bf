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

  int operator()(const Boxes<double>& q) const {
    if (!ode_.is_ready()) return AXISCERT_UNDECIDED;
    const dGeomID a = placed(q.a), b = placed(q.b);
    dContactGeom contacts[8];
    const int count = dCollide(a, b, flags, contacts, sizeof contacts[0]);
    dGeomDestroy(a);
    dGeomDestroy(b);
    for (int i = 0; i < count; ++i) {
      if (std::isnan(contacts[i].depth)) return AXISCERT_INVALID;
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
