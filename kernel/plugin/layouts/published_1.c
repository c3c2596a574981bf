/* The published test as a plug-in of version 1, in both precisions with its comparisons; faults/none.c is the same in
 * version 2. */
#include "kernel/plugin/layouts/version_1.h"

#define real float
#define OF_REAL(name) name##_binary32
#include "kernel/sphere_triangle/faults/published_test.h"
#undef real
#undef OF_REAL

#define real double
#define OF_REAL(name) name##_binary64
#include "kernel/sphere_triangle/faults/published_test.h"
#undef real
#undef OF_REAL

#define RUN(run, real, one_query)                                                     \
  static void run(const axiscert_batch* batch, const axiscert_answers* answers) {     \
    for (size_t i = 0; i < batch->size; ++i) {                                        \
      real v[13];                                                                     \
      uint64_t bits = 0;                                                              \
      for (int k = 0; k < 13; ++k) v[k] = ((const real*)batch->coordinate[k])[i];     \
      answers->verdict[i] = (uint8_t)one_query(v, v + 3, v + 6, v + 9, v[12], &bits); \
      if (answers->comparisons) answers->comparisons[i] = (uint16_t)bits;             \
    }                                                                                 \
  }
RUN(run_binary32, float, published_binary32)
RUN(run_binary64, double, published_binary64)

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static const axiscert_kernel kernels[2] = {
      {.abi = 1, .precision = 32, .name = "published", .run = run_binary32, .exposes = 1, .conforms_to = "published"},
      {.abi = 1, .precision = 64, .name = "published", .run = run_binary64, .exposes = 1, .conforms_to = "published"}};
  return index < 2 ? &kernels[index] : NULL;
}
