/* The radius is used in place of its square, so the sphere has radius sqrt(r). Missed contacts where r > 1, phantom
   ones where r < 1. */
#define RADIUS_SQUARED r

#include "kernel/sphere_triangle/faults/published.h"
