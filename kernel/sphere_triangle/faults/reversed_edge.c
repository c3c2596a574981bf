/* AC is used for CA, while the foot of the centre is still taken from C along CA: it lands on the other side of C.
 * Missed and phantom contacts. */
#define EDGE_CA (C[k] - A[k])

#include "kernel/sphere_triangle/faults/published.h"
