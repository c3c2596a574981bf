/* The published test as a plug-in, in both precisions; see published_test.h for the parts that a fault may change. A
 * fault that makes the comparisons meaningless, or whose verdict does not follow from them, also defines EXPOSES as
 * AXISCERT_VERDICT_ONLY.
 */
#include "kernel/include/axiscert/plugin.h"

#ifndef EXPOSES
#define EXPOSES AXISCERT_COMPARISONS
#endif

/* The file of the fault, which includes this one. */
#define SOURCE __BASE_FILE__ ":1"

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

AXISCERT_BATCH_WITH_COMPARISONS(run_binary32, float, published_binary32)
AXISCERT_BATCH_WITH_COMPARISONS(run_binary64, double, published_binary64)

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static const axiscert_kernel kernels[2] = {{.abi = AXISCERT_PLUGIN_ABI,
                                              .precision = 32,
                                              .size = sizeof(axiscert_kernel),
                                              .name = "published",
                                              .column_count = 13,
                                              .run = run_binary32,
                                              .source = SOURCE,
                                              .exposes = EXPOSES,
                                              .conforms_to = "published"},
                                             {.abi = AXISCERT_PLUGIN_ABI,
                                              .precision = 64,
                                              .size = sizeof(axiscert_kernel),
                                              .name = "published",
                                              .column_count = 13,
                                              .run = run_binary64,
                                              .source = SOURCE,
                                              .exposes = EXPOSES,
                                              .conforms_to = "published"}};
  return index < 2 ? &kernels[index] : NULL;
}
