#include "fuzz/queries/capabilities.h"

namespace axiscert {

const Capabilities& sphere_triangle_capabilities() {
  static const Capabilities all = {};
  return all;
}

}  // namespace axiscert
