/* Vertex B separates as soon as A lies beyond its plane, wherever C does. Missed contacts only. */
#define VERTEX_B_SIDE_C 1

#include "kernel/sphere_triangle/faults/published.h"
