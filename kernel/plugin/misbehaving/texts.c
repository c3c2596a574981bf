/* Says of itself what a terminal, a browser or an editor would obey: it forges a line, colours, and turns text around.
 */
#include "kernel/plugin/misbehaving/right.h"

#undef AXISCERT_SOURCE
#define AXISCERT_SOURCE "src/\xe2\x80\xaetxet\x1b[31m.c:8"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->count; ++i) {
    answers->verdict[i] = misbehaves(radius(batch, i)) ? 7 : right(batch, i);
  }
}
MISBEHAVING("evil\x1b[2J\nother binary32: exact: met\xe2\x80\xae", run,
            .summary =
                "\x9b"
                "31m\x07 <b>|`]]>&\" \xe2\x81\xa6turned\r")
