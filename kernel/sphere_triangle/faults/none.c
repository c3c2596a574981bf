/* No fault: the control. It equals the built-in `published` bit for bit. */
#include "kernel/sphere_triangle/faults/published.h"
