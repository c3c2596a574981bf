#include "fuzz/queries/capabilities.h"

namespace axiscert {

const Capabilities& moving_sphere_capabilities() {
  static const Capabilities all = {};
  return all;
}

}  // namespace axiscert
