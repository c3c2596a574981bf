/* The plane is taken with its sign: a sphere behind the triangle is never found clear of it. Phantom contacts only. */
#define PLANE_RADIUS (d > 0 && d * d > rr * e)

#include "kernel/sphere_triangle/faults/published.h"
