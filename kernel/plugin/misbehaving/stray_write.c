/* Writes thousands of entries past the end of its output. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  answer_rightly(batch, answers);
  answers->verdict[batch->count + 100000] = 1;
}
MISBEHAVING("stray_write", run)
