/* Made for a later version of the interface. */
#include "kernel/plugin/misbehaving/right.h"

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static const axiscert_kernel kernel = {.abi = AXISCERT_PLUGIN_ABI + 1,
                                         .precision = 32,
                                         .size = sizeof(axiscert_kernel),
                                         .name = "wrong_abi",
                                         .column_count = 13,
                                         .run = answer_rightly};
  return index == 0 ? &kernel : NULL;
}
