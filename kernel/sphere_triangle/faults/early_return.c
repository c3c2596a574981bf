/* Returns "contact" where the plane cuts the sphere, as if the triangle were its whole plane. Phantom contacts only;
 * the comparisons after it are never made. */
#define EXPOSES AXISCERT_VERDICT_ONLY
#define AFTER_PLANE \
  if (!plane_radius) return AXISCERT_CONTACT

#include "kernel/sphere_triangle/faults/published.h"
