/* Touching vertex A from outside counts as separated; nothing else changes. Missed contacts at depth 0 only. */
#define VERTEX_A_RADIUS (aa >= rr)

#include "kernel/sphere_triangle/faults/published.h"
