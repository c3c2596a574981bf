/* Writes through a null pointer on a query of large radius. */
#include "kernel/plugin/misbehaving/right.h"

static volatile int* volatile nowhere = NULL;

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) {
    if (misbehaves(radius(batch, i))) *nowhere = 0;
    answers->verdict[i] = right(batch, i);
  }
}
MISBEHAVING("crash", run)
