/* An edge with a squared length below 1e-12 is taken as its first vertex. */
#define real double
#define IS_POINT(whole) ((whole) < 1e-12)
#include "kernel/sphere_triangle/absolute/nearest_point.h"

AXISCERT_PLUGIN(double, "short_edge", nearest_point)
