/* Returns "separated" where they intersect, and the reverse. Every answer is wrong. */
#define EXPOSES AXISCERT_VERDICT_ONLY
#define VERDICT (separated ? AXISCERT_CONTACT : AXISCERT_SEPARATED)

#include "kernel/sphere_triangle/faults/published.h"
