/* A kernel with only the members that it needs: the struct ends after `run`, at the end of a page, and the next page
 * cannot be read. */
#include "kernel/plugin/declarations/at_page_end.h"

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  const size_t size = offsetof(axiscert_kernel, predicate);
  const axiscert_kernel kernel = {
      .abi = AXISCERT_PLUGIN_ABI, .precision = 32, .size = size, .name = "short", .column_count = 13, .run = undecided};
  return index == 0 ? at_page_end(&kernel, size) : NULL;
}
