/* A centre is inside by 1e-10 or not at all: missed contacts inside small triangles. */
#define real double
#define IS_INSIDE(side) ((side) > 1e-10)
#include "kernel/sphere_triangle/absolute/nearest_point.h"

AXISCERT_PLUGIN(double, "inside_epsilon", nearest_point)
