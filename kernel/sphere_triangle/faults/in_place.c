/* AB is computed in place, B -= A, and B is used as a vertex afterwards: its dot products are those of an edge
 * vector. Missed and phantom contacts. */
#define AFTER_PLANE \
  for (k = 0; k < 3; ++k) B[k] -= A[k]

#include "kernel/sphere_triangle/faults/published.h"
