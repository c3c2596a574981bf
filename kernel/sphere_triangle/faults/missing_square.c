/* The distance from line AB is scaled by e1 squared and the radius by e1 once, which is right only for an edge of
 * length 1. Missed contacts along longer edges, phantom contacts along shorter ones. */
#define EDGE_AB_RADIUS (DOT(Q1, Q1) > rr * e1)

#include "kernel/sphere_triangle/faults/published.h"
