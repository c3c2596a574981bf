/* Returns 7, which is no verdict, on a query of large radius. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) {
    answers->verdict[i] = misbehaves(radius(batch, i)) ? 7 : right(batch, i);
  }
}
MISBEHAVING("not_a_verdict", run)
