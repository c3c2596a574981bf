/* The vector from the foot on BC leads to B in place of A, along the edge itself, so the side comparison is 0 > 0.
 * In exact arithmetic edge BC separates nothing: phantom contacts only. Rounding gives the zero either sign: missed
 * contacts too. */
#define FROM_BC_TO_A (B[k] * e2 - Q2[k])

#include "kernel/sphere_triangle/faults/published.h"
