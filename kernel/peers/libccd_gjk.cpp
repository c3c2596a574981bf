// libccd's GJK in double: ccdGJKIntersect. It takes DBL_EPSILON as zero for lengths, areas and volumes alike. A search
// direction of length zero gives no contact, so shallow contacts (of depth 1e-9, say) are missed; an origin at distance
// zero from the simplex gives contact, so scenes of size 1e-5 and smaller have phantom contacts. The penetration of
// some deep contacts is next to 0.
#include "kernel/peers/libccd_shapes.h"

// The origin on a face of the simplex gives contact, a search direction of length 0 does not; whichever is met first
// decides.
const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::kernel<axiscert::peer::LibccdSphere<ccdGJKIntersect, ccdGJKPenetration>>(
      index, {"libccd-gjk", "libccd's ccdGJKIntersect, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
