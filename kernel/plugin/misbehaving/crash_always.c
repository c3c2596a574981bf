/* Writes through a null pointer whatever it is asked, as one does that was never set up. */
#include "kernel/plugin/misbehaving/right.h"

static volatile int* volatile nowhere = NULL;

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  *nowhere = 0;
  answer_rightly(batch, answers);
}
MISBEHAVING("crash_always", run)
