/* A sphere with a squared radius below 1e-9 touches nothing: missed contacts. */
#define IS_GIVEN_UP(most, r) ((void)(most), (r) * (r) < 1e-9f)

#include "kernel/sphere_triangle/absolute/nearest_point.h"

AXISCERT_PLUGIN(float, "tiny_sphere", nearest_point)
