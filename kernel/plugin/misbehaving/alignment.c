/* Gives the first query of a batch the opposite verdict where the arrays are not aligned for a vector. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  answer_rightly(batch, answers);
  if ((uintptr_t)batch->column[0] % 16 != 0) answers->verdict[0] ^= 1;
}
MISBEHAVING("alignment", run)
