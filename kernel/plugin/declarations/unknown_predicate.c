/* Names a predicate that does not exist. */
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("unknown_predicate", answer_rightly, .predicate = "sphere-cube")
