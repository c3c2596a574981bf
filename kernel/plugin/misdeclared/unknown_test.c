/* Names a test that does not exist. */
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("unknown_test", answer_rightly, .test = "sphere-cube")
