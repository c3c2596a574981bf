/* Turns flush-to-zero and denormals-are-zero on when it is loaded, as what -ffast-math links does. Its answers are right.
 */
#include "kernel/plugin/misbehaving/flushing.h"
#include "kernel/plugin/misbehaving/right.h"

__attribute__((constructor)) static void at_load(void) { flush_to_zero(); }

MISBEHAVING("flush_at_load", answer_rightly)
