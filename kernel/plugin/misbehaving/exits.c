/* Leaves the process on a query of large radius, as a library does that takes bad input for the end of it. */
#include <stdlib.h>

#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) {
    if (misbehaves(radius(batch, i))) exit(0);
    answers->verdict[i] = right(batch, i);
  }
}
MISBEHAVING("exits", run)
