#include "fuzz/queries/capabilities.h"

#include "fuzz/sphere_triangle/diagnosis_scenes.h"
#include "fuzz/sphere_triangle/screen.h"

namespace axiscert {

const Capabilities& sphere_triangle_capabilities() {
  static const Capabilities all = {
      .screens = &sphere_triangle_screens(),
      .has_input_classes = true,
      .diagnosis_scenes = &diagnosis::sphere_triangle_scenes(),
  };
  return all;
}

}  // namespace axiscert
