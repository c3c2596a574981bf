/* A centre with |A.V| below 1e-7 is taken to lie in the plane: phantom contacts. */
#define IS_IN_PLANE(offset) (fabsf(offset) < 1e-7f)

#include "kernel/sphere_triangle/absolute/nearest_point.h"

AXISCERT_PLUGIN(float, "in_plane", nearest_point)
