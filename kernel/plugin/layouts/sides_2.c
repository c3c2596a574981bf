/* A plug-in of version 2 that gives both sides of each comparison. */
#include "kernel/include/axiscert/plugin.h"

#define real float
#define batch_column(k) batch->column[k]
#define bits_of_type(bits) (bits)
#define has_sides answers->lhs
#include "kernel/plugin/layouts/sides.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  show_sides(batch->count, batch, answers);
}

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static const axiscert_kernel kernel = {.abi = AXISCERT_PLUGIN_ABI,
                                         .precision = 32,
                                         .size = sizeof(axiscert_kernel),
                                         .name = "sides",
                                         .column_count = 13,
                                         .run = run,
                                         .exposes = AXISCERT_SIDES};
  return index == 0 ? &kernel : NULL;
}
