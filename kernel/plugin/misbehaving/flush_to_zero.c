/* Turns flush-to-zero and denormals-are-zero on and leaves them on; what it has answered by then is right. */
#include "kernel/plugin/misbehaving/flushing.h"
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  answer_rightly(batch, answers);
  flush_to_zero();
}
MISBEHAVING("flush_to_zero", run)
