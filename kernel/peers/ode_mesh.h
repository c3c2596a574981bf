// ODE's triangle meshes, of one triangle in both windings: a mesh is one-sided.
#pragma once

#include <ode/ode.h>

#include "kernel/peers/peer.h"

namespace axiscert::peer {

static_assert(sizeof(dReal) == 8);

// ODE, started for as long as this exists.
class OdeMesh {
 public:
  OdeMesh() : is_ready_(dInitODE2(0) != 0 && dAllocateODEDataForThread(dAllocateMaskAll) != 0) {}
  ~OdeMesh() { dCloseODE(); }
  OdeMesh(const OdeMesh&) = delete;
  OdeMesh& operator=(const OdeMesh&) = delete;

  bool is_ready() const { return is_ready_; }

  // The verdict of dCollide on a body, which is destroyed, and the triangle; `invalid` where a contact's depth is NaN.
  // Its normal pushes the first geometry, which is the body, and its point is the triangle's.
  int collide(dGeomID body, const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c,
              Contact<double>* said = nullptr) const {
    // The mesh keeps pointers to these arrays.
    const double vertices[3][3] = {{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}};
    constexpr dTriIndex windings[6] = {0, 1, 2, 0, 2, 1};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, vertices, sizeof vertices[0], 3, windings, 6, 3 * sizeof(dTriIndex));
    const dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    dContactGeom contacts[4];
    const int count = dCollide(body, mesh, 4, contacts, sizeof contacts[0]);
    dGeomDestroy(body);
    dGeomDestroy(mesh);
    dGeomTriMeshDataDestroy(data);

    for (int i = 0; i < count; ++i) {
      const dContactGeom& one = contacts[i];
      if (std::isnan(one.depth)) return AXISCERT_INVALID;
      if (said != nullptr && said->is_new_deepest(-one.depth)) {
        *said = {-one.depth, {one.normal[0], one.normal[1], one.normal[2]}, {one.pos[0], one.pos[1], one.pos[2]}};
      }
    }
    return verdict_of(count > 0);
  }

 private:
  bool is_ready_;
};

}  // namespace axiscert::peer
