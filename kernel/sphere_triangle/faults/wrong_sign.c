/* The foot of the centre on AB is computed with a plus: a point of the line AB on the wrong side of A, farther from
 * the centre than the nearest point. Missed and phantom contacts. */
#define FOOT_ON_AB (A[k] * e1 + AB[k] * d1)

#include "kernel/sphere_triangle/faults/published.h"
