// ODE has no sweep: what the sphere covers on its way is a capsule, here a static one against a triangle mesh of this
// triangle in both windings, in double: dCollide. A verdict alone. The description applies to ODE 0.16.2 with OPCODE;
// a capsule of radius 0 or of length 0 is none to ODE, and is declined.
//
// The capsule's axis is turned to d by a rotation, which is rounded: shallow contacts may be missed or invented.
#include "kernel/peers/moving_sphere/sweep.h"
#include "kernel/peers/ode_mesh.h"

namespace axiscert::peer {
namespace {

class OdeCapsule {
 public:
  using Real = double;
  static constexpr std::size_t measure_count = 0;
  static constexpr bool may_decline = true;

  int operator()(const Sweep<double>& q, FirstContact<double>&) const {
    const double length = std::hypot(q.d.x, q.d.y, q.d.z);
    if (!mesh_.is_ready() || !(q.r > 0) || !(length > 0) || !std::isfinite(length)) return AXISCERT_UNDECIDED;
    const dGeomID capsule = dCreateCapsule(nullptr, q.r, length);
    dMatrix3 turned;
    dRFromZAxis(turned, q.d.x / length, q.d.y / length, q.d.z / length);
    dGeomSetRotation(capsule, turned);
    const Vec3<double> middle = q.p + q.d * 0.5;
    dGeomSetPosition(capsule, middle.x, middle.y, middle.z);
    return mesh_.collide(capsule, q.a, q.b, q.c);
  }

 private:
  OdeMesh mesh_;
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::sweep_kernel<axiscert::peer::OdeCapsule>(
      index, {"ode-capsule", "ODE's dCollide of a capsule and a triangle mesh, both windings, double",
              AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
