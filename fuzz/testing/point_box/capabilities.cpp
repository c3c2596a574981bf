#include "fuzz/queries/capabilities.h"

namespace axiscert {

const Capabilities& point_box_capabilities() {
  static const Capabilities all = {.section_of_forms = "docs/kernels.md"};
  return all;
}

}  // namespace axiscert
