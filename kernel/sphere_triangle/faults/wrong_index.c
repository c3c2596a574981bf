/* One index of the cross product is wrong: the vector is not normal to the triangle, and the plane is not the
 * triangle's. Missed and phantom contacts. */
#define CROSS_Y(u, v) (u[2] * v[0] - u[0] * v[1])

#include "kernel/sphere_triangle/faults/published.h"
