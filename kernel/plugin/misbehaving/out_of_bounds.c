/* Writes one verdict past the end of each batch: <= for <. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i <= batch->count; ++i)
    answers->verdict[i] = i < batch->count ? right(batch, i) : AXISCERT_CONTACT;
}
MISBEHAVING("out_of_bounds", run)
