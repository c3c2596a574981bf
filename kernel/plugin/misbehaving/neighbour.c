/* Takes a query for the one before it in the batch where their triangles begin with the same coordinate, and gives it
 * that one's answer. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  const float* x = (const float*)batch->column[0];
  for (size_t i = 0; i < batch->count; ++i) {
    answers->verdict[i] = i > 0 && x[i] == x[i - 1] ? answers->verdict[i - 1] : right(batch, i);
  }
}
MISBEHAVING("neighbour", run)
