#include "fuzz/queries/capabilities.h"

#include "fuzz/moving_sphere/mesh_motion.h"

namespace axiscert {

const Capabilities& moving_sphere_capabilities() {
  static const Capabilities all = {.mesh = &moving_sphere_mesh};
  return all;
}

}  // namespace axiscert
