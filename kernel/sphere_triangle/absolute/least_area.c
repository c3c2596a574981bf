/* A triangle with |V|^2 below 1e-8 has no face: missed contacts inside small triangles. */
#define HAS_FACE(vv) ((vv) > 1e-8f)

#include "kernel/sphere_triangle/absolute/nearest_point.h"

AXISCERT_PLUGIN(float, "least_area", nearest_point)
