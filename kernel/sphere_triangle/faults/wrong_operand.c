/* The foot on BC is computed along AB: a point on no edge. Missed and phantom contacts. */
#define FOOT_ON_BC (B[k] * e2 - AB[k] * d2)

#include "kernel/sphere_triangle/faults/published.h"
