/* A kernel that gives both sides of each comparison, which a test can tell apart: the left side of comparison k is
 * number k % 13 of the query, the right side is k. */
#include "kernel/include/axiscert/plugin.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  static const unsigned axes[7] = {0x0001, 0x000e, 0x0070, 0x0380, 0x0c00, 0x3000, 0xc000};
  for (size_t i = 0; i < batch->count; ++i) {
    unsigned bits = 0, separates = 0;
    for (unsigned k = 0; k < 16; ++k) {
      const float lhs = ((const float*)batch->column[k % 13])[i], rhs = (float)k;
      bits |= (unsigned)(lhs > rhs) << k;
      if (!answers->lhs) continue;
      ((float*)answers->lhs[k])[i] = lhs;
      ((float*)answers->rhs[k])[i] = rhs;
    }
    for (int k = 0; k < 7; ++k) separates |= (bits & axes[k]) == axes[k];
    answers->verdict[i] = separates ? AXISCERT_SEPARATED : AXISCERT_CONTACT;
    if (answers->comparisons) answers->comparisons[i] = bits;
  }
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
