/* A slack of 1e-5 on the distance: phantom contacts. */
#define real double
#define IS_SEPARATED(squared, r) (sqrt(squared) > (r) + 1e-5)
#include "kernel/sphere_triangle/absolute/nearest_point.h"

AXISCERT_PLUGIN(double, "slack_distance", nearest_point)
