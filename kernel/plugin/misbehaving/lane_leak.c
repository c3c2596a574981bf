/* In a batch of an odd number of queries, each has the radius of the next. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  const void* column[13];
  axiscert_batch leaking = *batch;
  answer_rightly(batch, answers);
  if (batch->count % 2 == 0) return;
  for (int k = 0; k < 13; ++k) column[k] = batch->column[k];
  column[12] = (const float*)column[12] + 1;
  leaking.column = column;
  leaking.count = batch->count - 1;
  answer_rightly(&leaking, answers);
}
MISBEHAVING("lane_leak", run)
