/* Functions that the plug-ins with short structs share. */
#define _GNU_SOURCE
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "kernel/include/axiscert/plugin.h"

static void undecided(const axiscert_batch* batch, const axiscert_answers* answers) {
  memset(answers->verdict, AXISCERT_UNDECIDED, batch->count);
}

/* A copy of the first `size` bytes of a struct, whose next byte cannot be read. */
static const void* at_page_end(const void* from, size_t size) {
  const size_t page = (size_t)sysconf(_SC_PAGESIZE);
  char* const pages = mmap(NULL, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  mprotect(pages + page, page, PROT_NONE);
  return memcpy(pages + page - size, from, size);
}
