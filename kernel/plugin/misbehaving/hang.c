/* Spins for ever on a query of large radius: an iteration that does not converge. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) {
    volatile float residual = radius(batch, i);
    while (misbehaves(residual)) residual = residual * 1.0f;
    answers->verdict[i] = right(batch, i);
  }
}
MISBEHAVING("hang", run)
