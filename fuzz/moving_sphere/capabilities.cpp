#include "fuzz/queries/capabilities.h"

#include "fuzz/moving_sphere/mesh_motion.h"
#include "fuzz/queries/images.h"

namespace axiscert {

const Capabilities& moving_sphere_capabilities() {
  static const Capabilities all = {.image_groups = moving_sphere_image_groups(), .mesh = &moving_sphere_mesh};
  return all;
}

}  // namespace axiscert
