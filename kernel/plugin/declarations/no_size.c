/* Leaves the size of its kernel zero. */
#define SIZE 0
#include "kernel/plugin/misbehaving/right.h"

MISBEHAVING("no_size", answer_rightly)
