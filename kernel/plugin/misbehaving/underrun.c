/* Writes one verdict before the beginning of each batch: counts down one too far. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (ptrdiff_t i = (ptrdiff_t)batch->count - 1; i >= -1; --i) {
    answers->verdict[i] = i >= 0 ? right(batch, (size_t)i) : AXISCERT_CONTACT;
  }
}
MISBEHAVING("underrun", run)
