/* Goes 8 queries at a time; where fewer are left over, the last of them gets the opposite verdict. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  answer_rightly(batch, answers);
  if (batch->count % 8 != 0) answers->verdict[batch->count - 1] ^= 1;
}
MISBEHAVING("last_lane", run)
