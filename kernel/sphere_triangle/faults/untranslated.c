/* C -= P is forgotten: the triangle's third vertex is elsewhere unless the centre is the origin. Missed and phantom
 * contacts. */
#define C_TRANSLATED c[k]

#include "kernel/sphere_triangle/faults/published.h"
