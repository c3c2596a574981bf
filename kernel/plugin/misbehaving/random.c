/* Answers from a generator whose state it keeps from call to call, whatever the query. */
#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  static uint64_t state = 1;
  for (size_t i = 0; i < batch->count; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    answers->verdict[i] = (uint8_t)(state >> 63);
  }
}
MISBEHAVING("random", run)
