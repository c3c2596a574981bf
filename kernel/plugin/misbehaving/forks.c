/* Leaves a process behind that holds all its files open, then aborts, on a query of large radius. */
#define _GNU_SOURCE
#include <stdlib.h>
#include <unistd.h>

#include "kernel/plugin/misbehaving/right.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) {
    if (misbehaves(radius(batch, i))) {
      if (fork() == 0) {
        sleep(1000);
        _exit(0);
      }
      abort();
    }
    answers->verdict[i] = right(batch, i);
  }
}
MISBEHAVING("forks", run)
