/* Has contact and separation the wrong way round. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  answer_rightly(batch, answers);
  for (size_t i = 0; i < batch->count; ++i) answers->verdict[i] ^= 1;
}
MISBEHAVING("exchanged", run)
