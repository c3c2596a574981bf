/* C -= P is forgotten: the triangle has its third vertex elsewhere, unless the centre is the origin. Missed and phantom
 * contacts. */
#define C_TRANSLATED c[k]

#include "kernel/sphere_triangle/faults/published.h"
