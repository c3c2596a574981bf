/* Translates the vertices where they lie, in the arrays that it was given to read. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  answer_rightly(batch, answers);
  for (int k = 0; k < 9; ++k) {
    float* vertex = (float*)(uintptr_t)batch->column[k];
    const float* centre = (const float*)batch->column[9 + k % 3];
    for (size_t i = 0; i < batch->count; ++i) vertex[i] -= centre[i];
  }
}
MISBEHAVING("writes_input", run)
