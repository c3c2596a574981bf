/* Names an entry that its test does not have. */
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("unknown_entry", answer_rightly, .test = "sphere-triangle", .entry = "edges")
