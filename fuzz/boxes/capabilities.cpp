#include "fuzz/queries/capabilities.h"

#include "fuzz/boxes/mesh_voxel.h"

namespace axiscert {

const Capabilities& box_box_capabilities() {
  static const Capabilities all = {};
  return all;
}

const Capabilities& box_triangle_capabilities() {
  static const Capabilities all = {.mesh = &box_triangle_mesh};
  return all;
}

}  // namespace axiscert
