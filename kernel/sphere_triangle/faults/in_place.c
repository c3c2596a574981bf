/* AB is made in place, B -= A, and B used as a vertex after that: its dot products are those of an edge vector. Missed
 * and phantom contacts. */
#define AFTER_PLANE \
  for (k = 0; k < 3; ++k) B[k] -= A[k]

#include "kernel/sphere_triangle/faults/published.h"
