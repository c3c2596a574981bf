/* A radius below 0.01 is taken as 0.01: phantom contacts of small spheres. */
#define RADIUS(r) ((r) < 0.01f ? 0.01f : (r))

#include "kernel/sphere_triangle/absolute/nearest_point.h"

AXISCERT_PLUGIN(float, "clamped_radius", nearest_point)
