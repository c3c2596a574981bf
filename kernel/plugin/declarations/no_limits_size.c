/* Leaves the size of its limits zero. */
#include "kernel/plugin/misbehaving/right.h"

static const axiscert_limits limits = {.greatest_coordinate = 100};
MISBEHAVING("no_limits_size", answer_rightly, .limits = &limits)
