/* Is killed by a signal without a name on a query of large radius. */
#define _GNU_SOURCE
#include <signal.h>

#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) {
    if (misbehaves(radius(batch, i))) raise(SIGRTMIN + 3);
    answers->verdict[i] = right(batch, i);
  }
}
MISBEHAVING("real_time_signal", run)
