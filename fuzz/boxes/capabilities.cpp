#include "fuzz/queries/capabilities.h"

namespace axiscert {

const Capabilities& box_box_capabilities() {
  static const Capabilities all = {};
  return all;
}

const Capabilities& box_triangle_capabilities() {
  static const Capabilities all = {};
  return all;
}

}  // namespace axiscert
