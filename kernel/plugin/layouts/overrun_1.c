/* A plug-in of version 1 that writes the comparisons of one query too many: two bytes beyond an array of two-byte
 * entries.
 */
#include "kernel/plugin/layouts/version_1.h"

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  for (size_t i = 0; i < batch->size; ++i) answers->verdict[i] = AXISCERT_CONTACT;
  for (size_t i = 0; i <= batch->size && answers->comparisons; ++i) answers->comparisons[i] = 0;
}

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static const axiscert_kernel kernel = {.abi = 1, .precision = 32, .name = "overrun", .run = run, .exposes = 1};
  return index == 0 ? &kernel : NULL;
}
