/* A line copied from vertex B keeps its bb: C separates from the side of A only where A lies beyond a plane farther
 * out than that through C. Phantom contacts only: where the other side comparison holds, bc > cc, bb is the larger
 * of the two. */
#define VERTEX_C_SIDE_A (ac > bb)

#include "kernel/sphere_triangle/faults/published.h"
