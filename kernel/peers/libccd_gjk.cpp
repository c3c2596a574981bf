// libccd's GJK in double: ccdGJKIntersect. DBL_EPSILON is its zero for lengths, areas and volumes alike. A search
// direction that is zero says no, so shallow contacts (of 1e-9, say) are missed; an origin at distance zero from the
// simplex says yes, so scenes of 1e-5 and smaller have phantom contacts.
#include "kernel/peers/libccd_shapes.h"

namespace axiscert::peer {
namespace {

struct LibccdGjk {
  using Real = double;

  int operator()(const Query<double>& q) const {
    const ccd_t ccd = sphere_and_triangle();
    return verdict_of(ccdGJKIntersect(&q, &q, &ccd) != 0);
  }
};

}  // namespace
}  // namespace axiscert::peer

// The origin on a face of the simplex is contact there, a direction of length 0 is not: which is met first decides.
const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::kernel<axiscert::peer::LibccdGjk>(
      index, {"libccd-gjk", "libccd's ccdGJKIntersect, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
