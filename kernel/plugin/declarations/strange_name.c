/* Has a name that is not text. */
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("caf\xe9\n", answer_rightly)
