/* The control: no absolute number. */
#include "kernel/sphere_triangle/absolute/nearest_point.h"

AXISCERT_PLUGIN(float, "none", nearest_point)
