/* A kernel without its last member, `may_decline`: the struct ends there, at the end of a page, and the next page
 * cannot be read. */
#include "kernel/plugin/declarations/at_page_end.h"

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  const size_t size = offsetof(axiscert_kernel, may_decline);
  const axiscert_kernel kernel = {.abi = AXISCERT_PLUGIN_ABI,
                                  .precision = 32,
                                  .size = size,
                                  .name = "all but the last",
                                  .column_count = 13,
                                  .run = undecided,
                                  .touching = AXISCERT_TOUCHING_IS_EITHER};
  return index == 0 ? at_page_end(&kernel, size) : NULL;
}
