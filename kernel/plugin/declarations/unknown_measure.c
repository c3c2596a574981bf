/* Declares a measure, and its predicate has none. */
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("unknown_measure", answer_rightly, .measure_count = 9)
