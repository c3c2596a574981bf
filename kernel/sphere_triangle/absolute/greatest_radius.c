/* A radius above 1000 is taken as 1000: missed contacts of large spheres. */
#define RADIUS(r) ((r) > 1000.0f ? 1000.0f : (r))

#include "kernel/sphere_triangle/absolute/nearest_point.h"

AXISCERT_PLUGIN(float, "greatest_radius", nearest_point)
