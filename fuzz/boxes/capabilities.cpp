#include "fuzz/queries/capabilities.h"

#include "fuzz/boxes/families/situations.h"
#include "fuzz/boxes/mesh_voxel.h"
#include "fuzz/diagnosis/scenes/scenes.h"

namespace axiscert {
namespace {

constexpr diagnosis::DiagnosisScenes box_scenes = {.words = {.length = "half extents",
                                                             .sided = "boxes",
                                                             .front = "the centre of the box is in front of the face",
                                                             .behind = "the centre of the box is behind the face",
                                                             .first = "A's place",
                                                             .second = "B's place"}};

constexpr std::string_view section_of_forms = "docs/boxes.md#from-the-definition-to-the-books";

}  // namespace

const Capabilities& box_box_capabilities() {
  static const Capabilities all = {.section_of_forms = section_of_forms,
                                   .situations = &boxes::box_box_situation::all,
                                   .diagnosis_scenes = &box_scenes};
  return all;
}

const Capabilities& box_triangle_capabilities() {
  static const Capabilities all = {.mesh = &box_triangle_mesh,
                                   .section_of_forms = section_of_forms,
                                   .situations = &boxes::box_triangle_situation::all,
                                   .diagnosis_scenes = &box_scenes};
  return all;
}

}  // namespace axiscert
