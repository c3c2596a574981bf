/* A slack of 1e-6 on the squared radius: phantom contacts. */
#define IS_SEPARATED(squared, r) ((squared) > (r) * (r) + 1e-6f)

#include "kernel/sphere_triangle/absolute/nearest_point.h"

AXISCERT_PLUGIN(float, "slack_squared", nearest_point)
