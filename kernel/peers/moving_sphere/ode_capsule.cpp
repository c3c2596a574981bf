// ODE has no sweep: what the sphere covers on its way is a capsule, here a static one against a triangle mesh of this
// triangle in both windings, in double: dCollide. A verdict alone. The description applies to ODE 0.16.2 with OPCODE;
// a capsule of radius 0 or of length 0 is none to ODE, and is declined.
//
// The capsule's axis is turned to d by a rotation, which is rounded: shallow contacts may be missed or invented.
#include <ode/ode.h>

#include "kernel/peers/moving_sphere/sweep.h"

namespace axiscert::peer {
namespace {

static_assert(sizeof(dReal) == 8);

class OdeCapsule {
 public:
  using Real = double;
  static constexpr std::size_t measure_count = 0;

  OdeCapsule() : is_ready_(dInitODE2(0) != 0 && dAllocateODEDataForThread(dAllocateMaskAll) != 0) {}
  ~OdeCapsule() { dCloseODE(); }
  OdeCapsule(const OdeCapsule&) = delete;
  OdeCapsule& operator=(const OdeCapsule&) = delete;

  int operator()(const Sweep<double>& q, FirstContact<double>&) const {
    const double length = std::hypot(q.d.x, q.d.y, q.d.z);
    if (!is_ready_ || !(q.r > 0) || !(length > 0) || !std::isfinite(length)) return AXISCERT_UNDECIDED;
    // The mesh keeps pointers to these arrays.
    const double vertices[3][3] = {{q.a.x, q.a.y, q.a.z}, {q.b.x, q.b.y, q.b.z}, {q.c.x, q.c.y, q.c.z}};
    constexpr dTriIndex windings[6] = {0, 1, 2, 0, 2, 1};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, vertices, sizeof vertices[0], 3, windings, 6, 3 * sizeof(dTriIndex));
    const dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    const dGeomID capsule = dCreateCapsule(nullptr, q.r, length);
    dMatrix3 turned;
    dRFromZAxis(turned, q.d.x / length, q.d.y / length, q.d.z / length);
    dGeomSetRotation(capsule, turned);
    const Vec3<double> middle = q.p + q.d * 0.5;
    dGeomSetPosition(capsule, middle.x, middle.y, middle.z);
    dContactGeom contacts[4];
    const int count = dCollide(capsule, mesh, 4, contacts, sizeof contacts[0]);
    dGeomDestroy(capsule);
    dGeomDestroy(mesh);
    dGeomTriMeshDataDestroy(data);

    for (int i = 0; i < count; ++i) {
      if (std::isnan(contacts[i].depth)) return AXISCERT_INVALID;
    }
    return verdict_of(count > 0);
  }

 private:
  bool is_ready_;
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::sweep_kernel<axiscert::peer::OdeCapsule>(
      index, {"ode-capsule", "ODE's dCollide of a capsule and a triangle mesh, both windings, double",
              AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
