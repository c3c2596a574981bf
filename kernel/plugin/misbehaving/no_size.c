/* Does not say how long its struct is: a member that was forgotten. */
#define SIZE 0
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("no_size", answer_rightly)
