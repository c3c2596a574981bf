/* Says of declining neither 0 nor 1. */
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("strange_decline", answer_rightly, .may_decline = 2)
