/* The third edge is forgotten: a sphere that only CA separates from the triangle is called a contact. Phantom contacts
 * only. */
#define EDGE_CA_RADIUS 0

#include "kernel/sphere_triangle/faults/published.h"
