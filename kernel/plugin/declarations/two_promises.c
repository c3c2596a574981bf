/* May decline in binary32 and, as it says, decides every query in binary64. */
#include "kernel/plugin/misbehaving/right.h"

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static const axiscert_kernel kernels[2] = {{.abi = AXISCERT_PLUGIN_ABI,
                                              .precision = 32,
                                              .size = sizeof(axiscert_kernel),
                                              .name = "two_promises",
                                              .column_count = 13,
                                              .run = answer_rightly,
                                              .may_decline = 1},
                                             {.abi = AXISCERT_PLUGIN_ABI,
                                              .precision = 64,
                                              .size = sizeof(axiscert_kernel),
                                              .name = "two_promises",
                                              .column_count = 13,
                                              .run = answer_rightly}};
  return index < 2 ? &kernels[index] : NULL;
}
