/* The last side comparison is reversed: edge CA separates spheres on the inside of the triangle and none on the
 * outside. Missed and phantom contacts. */
#define EDGE_CA_SIDE_B (DOT(Q3, QB) < 0)

#include "kernel/sphere_triangle/faults/published.h"
