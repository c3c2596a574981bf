// ODE's sphere against a triangle mesh of this one triangle, in double (Debian's build): dCollide. The description
// applies to ODE 0.16.2 with OPCODE.
//
// A mesh is one-sided, so it contains the triangle in both windings. Candidates are found in float and the contact in
// double, so contacts shallower than float's resolution are missed. ODE skips a triangle without a normal, so contacts
// with degenerate triangles are missed. A centre exactly on the triangle is a contact whose depth is NaN (a direction
// of length 0 is divided by its length); here that is `invalid`.
#include <ode/ode.h>

#include "kernel/peers/peer.h"

namespace axiscert::peer {
namespace {

static_assert(sizeof(dReal) == 8);

class Ode {
 public:
  using Real = double;

  Ode() : is_ready_(dInitODE2(0) != 0 && dAllocateODEDataForThread(dAllocateMaskAll) != 0) {}
  ~Ode() { dCloseODE(); }
  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;

  int operator()(const Query<double>& q) const {
    if (!is_ready_) return AXISCERT_UNDECIDED;
    // The mesh keeps pointers to these arrays.
    const double vertices[3][3] = {{q.a.x, q.a.y, q.a.z}, {q.b.x, q.b.y, q.b.z}, {q.c.x, q.c.y, q.c.z}};
    constexpr dTriIndex windings[6] = {0, 1, 2, 0, 2, 1};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, vertices, sizeof vertices[0], 3, windings, 6, 3 * sizeof(dTriIndex));
    const dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    const dGeomID sphere = dCreateSphere(nullptr, q.r);
    dGeomSetPosition(sphere, q.p.x, q.p.y, q.p.z);
    dContactGeom contacts[4];
    const int count = dCollide(sphere, mesh, 4, contacts, sizeof contacts[0]);
    dGeomDestroy(sphere);
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

// Contact iff distance <= radius.
const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::kernel<axiscert::peer::Ode>(
      index, {"ode", "ODE's dCollide of a sphere and a triangle mesh, both windings, double",
              AXISCERT_TOUCHING_IS_CONTACT, AXISCERT_SOURCE});
}
