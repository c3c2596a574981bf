/* One index of the cross product: the normal is no normal, and the plane not that of the triangle. Missed and phantom
 * contacts. */
#define CROSS_Y(u, v) (u[2] * v[0] - u[0] * v[1])

#include "kernel/sphere_triangle/faults/published.h"
