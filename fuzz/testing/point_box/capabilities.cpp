#include "fuzz/queries/capabilities.h"

namespace axiscert {

const Capabilities& point_box_capabilities() {
  static const Capabilities all = {};
  return all;
}

}  // namespace axiscert
