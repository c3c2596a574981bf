/* Names an entry that its predicate does not have. */
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("unknown_entry", answer_rightly, .predicate = "sphere-triangle", .entry = "edges")
