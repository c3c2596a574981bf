/* A whole plug-in whose kernel has the number ABI of another version, and no byte after it that can be read. */
#include "kernel/plugin/declarations/at_page_end.h"

const axiscert_kernel* axiscert_plugin(uint32_t index) {
  static const uint32_t abi = ABI;
  (void)undecided; /* no function of this version belongs to it */
  return index == 0 ? at_page_end(&abi, sizeof abi) : NULL;
}
