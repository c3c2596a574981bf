/* Counts its queries from call to call, and gives every 1000th the opposite verdict. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  static unsigned count;
  for (size_t i = 0; i < batch->count; ++i) answers->verdict[i] = right(batch, i) ^ (++count % 1000 == 0);
}
MISBEHAVING("state", run)
