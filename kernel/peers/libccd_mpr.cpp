// libccd's MPR in double: ccdMPRIntersect. It stops where a step gains less than mpr_tolerance, 1e-4 as a length: most
// shallower contacts are missed. Its loops ignore max_iterations, and on some queries (centre on the triangle, radius
// 0) they never end: the process that runs this needs a time limit. The penetration is that where the line of centres
// leaves.
#include "kernel/peers/libccd_shapes.h"

// While the algorithm looks for a portal, an origin on its surface counts as outside; once it has a portal, as inside.
const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::kernel<axiscert::peer::LibccdSphere<ccdMPRIntersect, ccdMPRPenetration>>(
      index, {"libccd-mpr", "libccd's ccdMPRIntersect, double", AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
