/* Coordinates are rounded to multiples of 1e-4. */
#define real float
#define KERNEL_NAME "coarse_grid"
#define COORDINATE(x) (roundf((x)*1e4f) * 1e-4f)
#include "kernel/sphere_triangle/absolute/batch.h"
