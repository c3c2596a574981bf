/* A query with a coordinate above 1e6 is given up as too far: missed contacts. */
#define real double
#define KERNEL_NAME "far_world"
#define IS_GIVEN_UP(most, r) ((void)(r), (most) > 1e6)
#include "kernel/sphere_triangle/absolute/batch.h"
