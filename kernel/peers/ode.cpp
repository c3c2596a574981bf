// ODE's sphere against a triangle mesh of this one triangle, in double (Debian's build): dCollide. The description
// applies to ODE 0.16.2 with OPCODE.
//
// A mesh is one-sided, so it contains the triangle in both windings. Candidates are found in float and the contact in
// double, so contacts shallower than float's resolution are missed. ODE skips a triangle without a normal, so contacts
// with degenerate triangles are missed. A centre exactly on the triangle is a contact whose depth is NaN (a direction
// of length 0 is divided by its length); here that is `invalid`. The normal is the plane's beside edges and corners
// too, and the depth is along it.
#include "kernel/peers/ode_mesh.h"

namespace axiscert::peer {
namespace {

class Ode {
 public:
  using Real = double;
  static constexpr std::size_t measure_count = whole_answer;
  static constexpr bool may_decline = true;

  int operator()(const Query<double>& q, Contact<double>& said) const {
    if (!mesh_.is_ready()) return AXISCERT_UNDECIDED;
    const dGeomID sphere = dCreateSphere(nullptr, q.r);
    dGeomSetPosition(sphere, q.p.x, q.p.y, q.p.z);
    return mesh_.collide(sphere, q.a, q.b, q.c, &said);
  }

 private:
  OdeMesh mesh_;
};

}  // namespace
}  // namespace axiscert::peer

// Contact iff distance <= radius.
const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::kernel<axiscert::peer::Ode>(
      index, {"ode", "ODE's dCollide of a sphere and a triangle mesh, both windings, double",
              AXISCERT_TOUCHING_IS_CONTACT, AXISCERT_SOURCE});
}
