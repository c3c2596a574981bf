/* Limits with their first member alone: the struct ends there, at the end of a page, and the next page cannot be read.
 */
#include "kernel/plugin/declarations/at_page_end.h"

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static axiscert_kernel kernel = {.abi = AXISCERT_PLUGIN_ABI,
                                   .precision = 32,
                                   .size = sizeof(axiscert_kernel),
                                   .name = "short limits",
                                   .column_count = 13,
                                   .run = undecided};
  const size_t size = offsetof(axiscert_limits, greatest_coordinate);
  const axiscert_limits limits = {.size = size, .least_coordinate = 0.5};
  kernel.limits = at_page_end(&limits, size);
  return index == 0 ? &kernel : NULL;
}
