/* Is for a test that is not there. */
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("unknown_test", answer_rightly, .test = "sphere-cube")
