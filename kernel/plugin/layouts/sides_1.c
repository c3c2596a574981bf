/* A plug-in of version 1 that gives both sides of each comparison and sets every member of its description. */
#include "kernel/plugin/layouts/version_1.h"

#define real float
#define batch_column(k) batch->coordinate[k]
#define bits_of_type(bits) (uint16_t)(bits)
#define has_sides answers->lhs[0]
#include "kernel/plugin/layouts/sides.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  show_sides(batch->size, batch, answers);
}

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static const axiscert_kernel kernel = {.abi = 1,
                                         .precision = 32,
                                         .name = "sides",
                                         .run = run,
                                         .summary = "built before",
                                         .exposes = 2,
                                         .touching = 2,
                                         .formulae = "reduced",
                                         .limits = {1e-9, 1e9, 1e-8, 1e-7, 1e7}};
  return index == 0 ? &kernel : NULL;
}
