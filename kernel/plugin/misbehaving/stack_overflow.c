/* Recurs without end on a query of large radius: a tree descent that never gets smaller. */
#include "kernel/plugin/misbehaving/right.h"

static float descend(float r) {
  volatile float frame[64];
  frame[0] = r;
  if (!misbehaves(r)) return r;
  frame[1] = descend(frame[0]);
  return frame[1] + frame[0];
}

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) {
    volatile float r = descend(radius(batch, i));
    (void)r;
    answers->verdict[i] = right(batch, i);
  }
}
MISBEHAVING("stack_overflow", run)
