/* The control in binary64. */
#define real double

#include "kernel/sphere_triangle/absolute/nearest_point.h"

AXISCERT_PLUGIN(double, "none64", nearest_point)
